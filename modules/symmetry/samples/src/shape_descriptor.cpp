#include "symmetry/samples/shape_descriptor.h"

#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "symmetry/samples/sample_settings.h"

#include <Eigen/LU>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr DescriptorSettings settings{};

/** Scales a part to unit variance times its weight, so that the weights mean the same on every surface. */
void
standardize(Eigen::MatrixXf& part, float weight)
{
  const float variance = part.squaredNorm() / static_cast<float>(std::max<Eigen::Index>(part.rows(), 1));
  if (variance > 0.0F) {
    part *= weight / std::sqrt(variance);
  }
}

/** Least-squares gradient of every column of \a values at a sample, in an orthonormal frame of its tangent plane (2
 * rows). Neighbours lie at their geodesic distance in the direction of their projection. */
Eigen::MatrixXf
tangentGradient(const CoarseSurface& surface, std::size_t sample, const Eigen::MatrixXf& values)
{
  const auto [u, v] = tangentFrame(surface.normals[sample]);
  Eigen::Matrix2f normal_matrix = Eigen::Matrix2f::Zero();
  Eigen::MatrixXf right_side = Eigen::MatrixXf::Zero(2, values.cols());
  for (const auto [other, geodesic] : surface.graph.edges(sample)) {
    const Vector3 offset = surface.points[other] - surface.points[sample];
    const Eigen::Vector2f projected(dot(offset, u), dot(offset, v));
    const float length = projected.norm();
    if (length > 0.0F && geodesic > 0.0F) {
      const Eigen::Vector2f direction = projected / length;
      normal_matrix += direction * direction.transpose();
      right_side += direction / geodesic * (values.row(other) - values.row(static_cast<Eigen::Index>(sample)));
    }
  }
  normal_matrix += (1e-3F * normal_matrix.trace() + 1e-12F) * Eigen::Matrix2f::Identity();
  return normal_matrix.inverse() * right_side;
}

/** Mean over each sample and its neighbours. */
Eigen::MatrixXf
smoothedOnce(const SurfaceGraph& graph, const Eigen::MatrixXf& values)
{
  Eigen::MatrixXf smoothed = values;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (const Index w : graph.neighboursOf(i)) {
      smoothed.row(row) += values.row(w);
    }
    smoothed.row(row) /= static_cast<float>(graph.degree(i) + 1);
  }
  return smoothed;
}

Eigen::MatrixXf
orientationFeature(const CoarseSurface& surface, const Eigen::MatrixXf& coordinates)
{
  const Eigen::Index d = coordinates.cols();
  Eigen::MatrixXf feature(coordinates.rows(), d * (d - 1) / 2);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Eigen::MatrixXf gradient = tangentGradient(surface, i, coordinates);
    Eigen::Index column = 0;
    for (Eigen::Index a = 0; a < d; ++a) {
      for (Eigen::Index b = a + 1; b < d; ++b) {
        feature(static_cast<Eigen::Index>(i), column++) =
            gradient(0, a) * gradient(1, b) - gradient(1, a) * gradient(0, b);
      }
    }
  }
  feature = smoothedOnce(surface.graph, feature);
  // A few places with steep gradients must not outweigh all others: rows are brought to similar length, which no
  // orthogonal action on the coordinates disturbs.
  const Eigen::VectorXf lengths = feature.rowwise().norm();
  const float typical = lengths.mean();
  if (typical > 0.0F) {
    feature = (lengths.array() + settings.row_floor * typical).inverse().matrix().asDiagonal() * feature;
  }
  return feature;
}

/** Height of each sample over the surface smoothed by several rounds of area-weighted averaging. */
Eigen::MatrixXf
curvatureFeature(const CoarseSurface& surface)
{
  constexpr std::array<int, 3> rounds = settings.smoothing;
  Eigen::MatrixXf feature(static_cast<Eigen::Index>(surface.size()), static_cast<Eigen::Index>(rounds.size()));
  std::vector<Vector3> smooth = surface.points;
  std::vector<Vector3> next(smooth.size());
  int done = 0;
  for (std::size_t scale = 0; scale < rounds.size(); ++scale) {
    for (; done < rounds[scale]; ++done) {
      for (std::size_t i = 0; i < surface.size(); ++i) {
        Vector3 sum = surface.areas[i] * smooth[i];
        float area = surface.areas[i];
        for (const Index j : surface.graph.neighboursOf(i)) {
          sum = sum + surface.areas[j] * smooth[j];
          area += surface.areas[j];
        }
        next[i] = area > 0.0F ? (1.0F / area) * sum : smooth[i];
      }
      smooth.swap(next);
    }
    for (std::size_t i = 0; i < surface.size(); ++i) {
      feature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(scale)) =
          dot(surface.normals[i], surface.points[i] - smooth[i]);
    }
  }
  feature.rowwise() -= feature.colwise().mean().eval();
  for (Eigen::Index scale = 0; scale < feature.cols(); ++scale) {
    const float deviation = feature.col(scale).norm();
    if (deviation > 0.0F) {
      feature.col(scale) /= deviation;
    }
  }
  return feature;
}

/** The matrix that acts on the upper triangle of an antisymmetric Omega as Omega -> R Omega R^T does: the 2 x 2 minors
 * of the leading \a d x d block of R. */
Eigen::MatrixXf
secondCompound(const Eigen::MatrixXf& action, Eigen::Index d)
{
  Eigen::MatrixXf minors(d * (d - 1) / 2, d * (d - 1) / 2);
  Eigen::Index row = 0;
  for (Eigen::Index a = 0; a < d; ++a) {
    for (Eigen::Index b = a + 1; b < d; ++b, ++row) {
      Eigen::Index column = 0;
      for (Eigen::Index c = 0; c < d; ++c) {
        for (Eigen::Index e = c + 1; e < d; ++e, ++column) {
          minors(row, column) = action(a, c) * action(b, e) - action(a, e) * action(b, c);
        }
      }
    }
  }
  return minors;
}

} // namespace

Eigen::MatrixXf
ShapeDescriptor::localParts(Eigen::Index rows) const
{
  Eigen::MatrixXf parts(rows, orientation.cols() + curvature.cols());
  parts << orientation.topRows(rows), curvature.topRows(rows);
  return parts;
}

Eigen::MatrixXf
ShapeDescriptor::joined(Eigen::Index rows) const
{
  Eigen::MatrixXf all(rows, spectral.cols() + orientation.cols() + curvature.cols());
  all << spectral.topRows(rows), localParts(rows);
  return all;
}

Eigen::MatrixXf
ShapeDescriptor::mirroredLocalParts(const Eigen::MatrixXf& action, Eigen::Index rows) const
{
  Eigen::MatrixXf parts(rows, orientation.cols() + curvature.cols());
  parts << -orientation.topRows(rows) * secondCompound(action, oriented_dimensions).transpose(),
      curvature.topRows(rows);
  return parts;
}

Eigen::MatrixXf
ShapeDescriptor::mirrored(const Eigen::MatrixXf& action, Eigen::Index rows) const
{
  Eigen::MatrixXf all(rows, spectral.cols() + orientation.cols() + curvature.cols());
  all << spectral.topRows(rows) * action.transpose(), mirroredLocalParts(action, rows);
  return all;
}

ShapeDescriptor
describeShape(const CoarseSurface& surface,
              const LaplacianBasis& basis,
              int dimensions,
              const DescriptorWeights& weights)
{
  const auto d = std::min<Eigen::Index>(dimensions, basis.functions.cols() - 1);
  ShapeDescriptor descriptor;
  descriptor.spectral =
      basis.functions.middleCols(1, d) * basis.eigenvalues.segment(1, d).cwiseSqrt().cwiseInverse().asDiagonal();
  standardize(descriptor.spectral, 1.0F);
  descriptor.oriented_dimensions = static_cast<int>(std::min<Eigen::Index>(d, weights.oriented_dimensions));
  descriptor.orientation = orientationFeature(surface, descriptor.spectral.leftCols(descriptor.oriented_dimensions));
  standardize(descriptor.orientation, weights.orientation);
  descriptor.curvature = curvatureFeature(surface);
  standardize(descriptor.curvature, weights.curvature);
  return descriptor;
}

} // namespace symmetry
} // namespace pcl
