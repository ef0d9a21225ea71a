#include "symmetry/samples/sample_interpolation.h"

#include "base/parallel.h"
#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "symmetry/samples/sample_settings.h"

#include <Eigen/LU>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr InterpolationSettings settings{};

/** Weights of a sample and its neighbours at one point. */
void
fitWeights(const CoarseSurface& coarse,
           Index owner,
           const Vector3& point,
           const Index* samples,
           std::size_t count,
           float* weights)
{
  const auto [u, v] = tangentFrame(coarse.normals[owner]);
  float radius = 0.0F;
  for (std::size_t i = 1; i < count; ++i) {
    radius += distance(coarse.points[samples[i]], coarse.points[owner]);
  }
  radius = std::max(radius / static_cast<float>(std::max<std::size_t>(count - 1, 1)), 1e-12F);

  // Rows of the design matrix: 1, position of the sample relative to the point in units of the mean spacing.
  Eigen::Matrix3f normal_matrix = Eigen::Matrix3f::Zero();
  Eigen::Matrix<float, 3, Eigen::Dynamic> design(3, static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 offset = (1.0F / radius) * (coarse.points[samples[i]] - point);
    const float weight = std::exp(-settings.falloff * dot(offset, offset)) + 1e-4F;
    const Eigen::Vector3f row(1.0F, dot(offset, u), dot(offset, v));
    normal_matrix += weight * row * row.transpose();
    design.col(static_cast<Eigen::Index>(i)) = weight * row;
  }
  const float trace = normal_matrix(0, 0);
  normal_matrix(1, 1) += settings.damping * trace;
  normal_matrix(2, 2) += settings.damping * trace;
  Eigen::Map<Eigen::RowVectorXf>(weights, static_cast<Eigen::Index>(count)) = normal_matrix.inverse().row(0) * design;
}

} // namespace

Eigen::RowVectorXf
SampleInterpolation::at(std::size_t v, const Eigen::MatrixXf& values) const
{
  Eigen::RowVectorXf sum = Eigen::RowVectorXf::Zero(values.cols());
  for (std::uint32_t e = offsets[v]; e < offsets[v + 1]; ++e) {
    sum += weights[e] * values.row(samples[e]);
  }
  return sum;
}

float
SampleInterpolation::at(std::size_t v, const std::vector<float>& values) const
{
  float sum = 0.0F;
  for (std::uint32_t e = offsets[v]; e < offsets[v + 1]; ++e) {
    sum += weights[e] * values[samples[e]];
  }
  return sum;
}

SampleInterpolation
interpolateFromSamples(const PreparedSurface& surface, const CoarseSurface& coarse)
{
  SampleInterpolation interpolation;
  interpolation.offsets.reserve(surface.size() + 1);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Index owner = coarse.cells.owner[v];
    const auto around = static_cast<std::uint32_t>(coarse.graph.degree(owner));
    interpolation.offsets.push_back(interpolation.offsets.back() + 1 + around);
  }
  interpolation.samples.resize(interpolation.offsets.back());
  interpolation.weights.resize(interpolation.offsets.back());
  constexpr std::size_t grain = 1024;
  parallelFor(
      surface.size(),
      [&](std::size_t v) {
        const Index owner = coarse.cells.owner[v];
        Index* samples = interpolation.samples.data() + interpolation.offsets[v];
        samples[0] = owner;
        const IndexRange around = coarse.graph.neighboursOf(owner);
        std::copy(around.begin(), around.end(), samples + 1);
        const std::size_t count = interpolation.offsets[v + 1] - interpolation.offsets[v];
        fitWeights(coarse, owner, surface.points[v], samples, count,
                   interpolation.weights.data() + interpolation.offsets[v]);
      },
      grain);
  return interpolation;
}

} // namespace symmetry
} // namespace pcl
