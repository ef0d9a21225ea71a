#include "symmetry/refine/bidirectional_matches.h"

#include "base/vector_math.h"

#include <Eigen/LU>

#include <cmath>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** Mean distance of each sample from those of the adjacent cells. */
std::vector<float>
spacingAtSamples(const CoarseSurface& coarse)
{
  std::vector<float> spacing(coarse.size(), 0.0F);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const std::uint32_t begin = coarse.graph.offsets[i];
    const std::uint32_t end = coarse.graph.offsets[i + 1];
    for (std::uint32_t e = begin; e < end; ++e) {
      spacing[i] += distance(coarse.points[coarse.graph.neighbours[e]], coarse.points[i]);
    }
    spacing[i] /= static_cast<float>(std::max(end - begin, 1U));
  }
  return spacing;
}

} // namespace

BidirectionalMatches::BidirectionalMatches(const PreparedSurface& surface,
                                           const CoarseSurface& coarse,
                                           const std::vector<Index>& partners)
    : surface_(surface), coarse_(coarse), offsets_(coarse.size() + 1, 0), spacing_(spacingAtSamples(coarse))
{
  const std::vector<Index>& owner = coarse.cells.owner;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    ++offsets_[i + 1];
    ++offsets_[owner[partners[i]] + 1];
  }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  matches_.resize(2 * coarse.size());
  std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const Index sample = coarse.cells.vertices[i];
    matches_[next[i]++] = {sample, partners[i]};
    matches_[next[owner[partners[i]]]++] = {partners[i], sample};
  }
}

Vector3
BidirectionalMatches::imageOf(Index point) const
{
  const Vector3& position = surface_.points[point];
  const Index home = coarse_.cells.owner[point];
  const Vector3& n = coarse_.normals[home];
  const Vector3 u = normalized(cross(n, std::abs(n[0]) < 0.9F ? Vector3{1, 0, 0} : Vector3{0, 1, 0}));
  const Vector3 v = cross(n, u);
  const float inverse_radius = 1.0F / std::max(spacing_[home], 1e-12F);

  // The design matrix has rows 1, position relative to the point in units of the spacing; the right side the images.
  Eigen::Matrix3f normal_matrix = Eigen::Matrix3f::Zero();
  Eigen::Matrix3f right_side = Eigen::Matrix3f::Zero();
  const auto add_cell = [&](Index cell) {
    for (std::uint32_t e = offsets_[cell]; e < offsets_[cell + 1]; ++e) {
      const Vector3 offset = inverse_radius * (surface_.points[matches_[e].from] - position);
      const float weight = std::exp(-2.0F * dot(offset, offset)) + 1e-4F;
      const Eigen::Vector3f row(1.0F, dot(offset, u), dot(offset, v));
      const Vector3& image = surface_.points[matches_[e].to];
      normal_matrix += weight * row * row.transpose();
      right_side += weight * row * Eigen::RowVector3f(image[0], image[1], image[2]);
    }
  };
  add_cell(home);
  for (std::uint32_t e = coarse_.graph.offsets[home]; e < coarse_.graph.offsets[home + 1]; ++e) {
    add_cell(coarse_.graph.neighbours[e]);
  }
  constexpr float damping = 0.02F;
  normal_matrix(1, 1) += damping * normal_matrix(0, 0);
  normal_matrix(2, 2) += damping * normal_matrix(0, 0);
  const Eigen::RowVector3f image = normal_matrix.inverse().row(0) * right_side;
  return {image.x(), image.y(), image.z()};
}

} // namespace symmetry
} // namespace pcl
