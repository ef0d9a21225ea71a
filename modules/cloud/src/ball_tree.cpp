#include "cloud/ball_tree.h"

#include "base/median_split.h"
#include "base/vector_math.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {

BallTree::BallTree(const std::vector<Vector3>& centres, const std::vector<float>& radii)
    : balls_(centres.size()), nodes_(1)
{
  std::iota(balls_.begin(), balls_.end(), 0);
  nodes_.front().end = static_cast<std::uint32_t>(balls_.size());
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    build(node, centres, radii);
  }
}

/** Fills in a node of which only the balls are known, and splits it at the middle of its longest side. */
void
BallTree::build(std::size_t node, const std::vector<Vector3>& centres, const std::vector<float>& radii)
{
  constexpr std::uint32_t most_balls = 8;
  const auto [begin, end] = std::pair(nodes_[node].begin, nodes_[node].end);
  BoundingBox box;
  float radius = 0.0F;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.extend(centres[balls_[i]]);
    radius = std::max(radius, radii[balls_[i]]);
  }
  nodes_[node].box = box;
  nodes_[node].radius = radius;
  if (end - begin <= most_balls) {
    return;
  }
  const std::uint32_t middle = splitAtMedian(centres, box, begin, end, balls_);
  nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().begin = begin;
  nodes_.back().end = middle;
  nodes_.emplace_back();
  nodes_.back().begin = middle;
  nodes_.back().end = end;
}

} // namespace symmetry
} // namespace pcl
