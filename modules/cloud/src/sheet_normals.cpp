#include "cloud/sheet_normals.h"

#include "base/parallel.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr SheetSettings settings{};

/** Where the neighbours of a point are, seen from it. */
class Offsets {
public:
  void
  collect(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t v)
  {
    offsets_.clear();
    float sum = 0.0F;
    for (const Index u : lists.of(v)) {
      if (static_cast<std::size_t>(u) != v) {
        offsets_.push_back(points[u] - points[v]);
        sum += norm(offsets_.back());
      }
    }
    const float near = settings.thickness * sum / static_cast<float>(std::max<std::size_t>(offsets_.size(), 1));
    inverse_square_ = near > 0.0F ? 1.0F / (near * near) : 0.0F;
  }

  /** Share of the neighbours that are near the plane through the point. */
  float
  shareInPlane(const Vector3& normal) const
  {
    float sum = 0.0F;
    for (const Vector3& x : offsets_) {
      sum += weight(x, normal);
    }
    return offsets_.empty() ? 1.0F : sum / static_cast<float>(offsets_.size());
  }

  /** Normal of the plane through the point that is fitted to the neighbours near it, from one near \a normal on. */
  Vector3
  fitted(Vector3 normal) const
  {
    for (int round = 0; round < settings.fitting_rounds; ++round) {
      Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
      for (const Vector3& offset : offsets_) {
        const Eigen::Vector3f x = std::sqrt(inverse_square_) * Eigen::Vector3f(offset[0], offset[1], offset[2]);
        covariance += weight(offset, normal) * x * x.transpose();
      }
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
      solver.computeDirect(covariance);
      const Eigen::Vector3f n = solver.eigenvectors().col(0);
      if (!n.allFinite()) {
        break;
      }
      normal = normalized({n.x(), n.y(), n.z()});
    }
    return normal;
  }

private:
  float
  weight(const Vector3& offset, const Vector3& normal) const
  {
    const float height = dot(offset, normal);
    const float square = height * height * inverse_square_;
    return 1.0F / (1.0F + square * square);
  }

  std::vector<Vector3> offsets_;
  float inverse_square_ = 0.0F; ///< of the height above a plane up to which a neighbour is near it
};

/** Mean of the normals of a point and its neighbours, those counting most that differ least, of either sign. */
Vector3
bilateralMean(const NeighbourLists& lists, const std::vector<Vector3>& normals, std::size_t v)
{
  Vector3 sum = normals[v];
  for (const Index u : lists.of(v)) {
    if (static_cast<std::size_t>(u) != v) {
      const float cosine = dot(normals[v], normals[u]);
      const float weight = std::exp((std::abs(cosine) - 1.0F) / settings.normal_difference);
      sum = sum + std::copysign(weight, cosine) * normals[u];
    }
  }
  return normalized(sum);
}

} // namespace

std::vector<Vector3>
sheetNormals(const std::vector<Vector3>& points, const NeighbourLists& neighbours, const std::vector<Vector3>& normals)
{
  constexpr std::size_t grain = 512;
  std::vector<Vector3> of_one_sheet(points.size());
  parallelBlocks(points.size(), grain, [&] {
    return [&, offsets = Offsets()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t v = begin; v < end; ++v) {
        offsets.collect(points, neighbours, v);
        const bool is_in_one_sheet = offsets.shareInPlane(normals[v]) >= settings.minimum_share;
        of_one_sheet[v] = is_in_one_sheet ? normals[v] : offsets.fitted(normals[v]);
      }
    };
  });
  std::vector<Vector3> averaged(points.size());
  parallelFor(
      points.size(), [&](std::size_t v) { averaged[v] = bilateralMean(neighbours, of_one_sheet, v); }, grain);
  return averaged;
}

} // namespace symmetry
} // namespace pcl
