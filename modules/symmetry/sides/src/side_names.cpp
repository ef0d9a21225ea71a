#include "symmetry/sides/side_names.h"

#include "base/vector_math.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr SideNameSettings settings{};

/** Mean 0 and mean square 1 over the surface; all zero where it is constant. */
Eigen::VectorXd
standardized(Eigen::VectorXd function, const CoarseSurface& coarse)
{
  const Eigen::VectorXd areas =
      Eigen::Map<const Eigen::VectorXf>(coarse.areas.data(), static_cast<Eigen::Index>(coarse.areas.size()))
          .cast<double>();
  function.array() -= areas.dot(function) / areas.sum();
  const double deviation = std::sqrt(areas.dot(function.cwiseAbs2()) / areas.sum());
  return deviation > settings.constant ? Eigen::VectorXd(function / deviation) : Eigen::VectorXd::Zero(function.size());
}

/** Logarithm of the heat that is left at each sample after a time. */
Eigen::VectorXd
heatSignature(const LaplacianBasis& basis, double time)
{
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(basis.functions.rows());
  for (Eigen::Index k = 1; k < basis.functions.cols(); ++k) {
    heat +=
        std::exp(-time * static_cast<double>(basis.eigenvalues(k))) * basis.functions.col(k).cast<double>().cwiseAbs2();
  }
  return heat.cwiseMax(settings.least_heat).array().log().matrix();
}

/** Plus one if normals point outwards, as seen from the middle, minus one if inwards. */
double
outwards(const CoarseSurface& coarse)
{
  Vector3 middle{};
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    middle = middle + coarse.areas[i] * coarse.points[i];
  }
  double volume = 0.0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    volume += coarse.areas[i] * dot(coarse.points[i] - middle, coarse.normals[i]);
  }
  return volume < 0.0 ? -1.0 : 1.0;
}

/** Integral of (h dg - g dh) ^ du / 2, the triangles turned as the normals say. */
double
enclosedArea(const CoarseSurface& coarse, const Eigen::VectorXd& g, const Eigen::VectorXd& h, const Eigen::VectorXd& u)
{
  double sum = 0.0;
  for (const Triangle& t : coarse.triangles) {
    const Vector3& a = coarse.points[t[0]];
    const Vector3 facing = cross(coarse.points[t[1]] - a, coarse.points[t[2]] - a);
    const Vector3 normal = coarse.normals[t[0]] + coarse.normals[t[1]] + coarse.normals[t[2]];
    const auto form = [&](const Eigen::VectorXd& factor, const Eigen::VectorXd& f) {
      const double mean = (factor(t[0]) + factor(t[1]) + factor(t[2])) / 3.0;
      return mean * ((f(t[1]) - f(t[0])) * (u(t[2]) - u(t[0])) - (f(t[2]) - f(t[0])) * (u(t[1]) - u(t[0])));
    };
    sum += (dot(facing, normal) < 0.0F ? -0.5 : 0.5) * (form(h, g) - form(g, h));
  }
  return sum;
}

} // namespace

double
chirality(const SampledSurface& sampled, const std::vector<float>& sides)
{
  const CoarseSurface& coarse = sampled.coarse;
  const auto samples = static_cast<Eigen::Index>(sides.size());
  if (sampled.descriptor.curvature.rows() != samples || sampled.landmarks.to_samples.rows() != samples) {
    return 0.0;
  }
  const double clear = settings.clear;
  const Eigen::VectorXd u =
      Eigen::Map<const Eigen::VectorXf>(sides.data(), samples).cast<double>().cwiseMax(-clear).cwiseMin(clear);
  const Eigen::VectorXd distance = standardized(sampled.landmarks.to_samples.rowwise().mean().cast<double>(), coarse);
  const Eigen::VectorXd coarse_heat = standardized(heatSignature(sampled.basis, settings.long_time), coarse);
  const Eigen::VectorXd fine_heat = standardized(heatSignature(sampled.basis, settings.short_time), coarse);
  const double out = outwards(coarse); // curvature as seen from outside, too
  const Eigen::VectorXd curvature =
      standardized(out * sampled.descriptor.curvature.col(settings.curvature_scale).cast<double>(), coarse);
  return -out * (enclosedArea(coarse, distance, coarse_heat, u) / settings.usual_distance_area +
                 enclosedArea(coarse, fine_heat, curvature, u) / settings.usual_curvature_area);
}

} // namespace symmetry
} // namespace pcl
