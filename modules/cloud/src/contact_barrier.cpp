#include "cloud/contact_barrier.h"

#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr ContactSettings settings{};

} // namespace

ContactBarrier::ContactBarrier(const std::vector<Vector3>& points, const std::vector<Vector3>& normals, float depth)
    : points_(points),
      normals_(normals),
      clearance_(settings.clearance * depth),
      depth_(depth),
      grid_(points, 2.0F * depth)
{
}

bool
ContactBarrier::isCrossedBy(const GraphEdge& edge) const
{
  const Vector3 a = points_[edge.a] - depth_ * normals_[edge.a];
  const Vector3 b = points_[edge.b] - depth_ * normals_[edge.b];
  const float length = distance(a, b);
  if (length > settings.longest_barred * depth_) {
    return false;
  }
  // In pieces: a box around all of a slanted edge holds cubes in proportion to the square of its length.
  const auto pieces = std::max(1, static_cast<int>(std::ceil(length / (settings.barrier_piece * depth_))));
  const auto place = [&](int piece) {
    return a + (static_cast<float>(piece) / static_cast<float>(pieces)) * (b - a);
  };
  for (int i = 0; i < pieces; ++i) {
    if (isMetBetween(place(i), place(i + 1), a, b)) {
      return true;
    }
  }
  return false;
}

/** Whether a point in the box around \a begin and \a end, part of the way from a to b, is in that way. Where points are so
 * much closer to each other than the depth that the box is full of them, the depth tells nothing. */
bool
ContactBarrier::isMetBetween(const Vector3& begin, const Vector3& end, const Vector3& a, const Vector3& b) const
{
  constexpr float rounding = 1.001F;
  Vector3 low;
  Vector3 high;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::min(begin[i], end[i]) - rounding * clearance_;
    high[i] = std::max(begin[i], end[i]) + rounding * clearance_;
  }
  const Vector3 along = b - a;
  const float inverse_square = 1.0F / std::max(dot(along, along), std::numeric_limits<float>::min());
  const float beyond = rounding * clearance_ * clearance_;
  const auto steps = std::max(2, static_cast<int>(std::ceil(distance(a, b) / (0.5F * clearance_))));
  std::size_t visited = 0;
  bool is_crowded = false;
  const bool is_met = grid_.anyInBox(low, high, [&](Index v) {
    is_crowded = ++visited > settings.barrier_points;
    if (is_crowded) {
      return true;
    }
    const Vector3 offset = points_[v] - a;
    const Vector3 nearest = std::clamp(inverse_square * dot(offset, along), 0.0F, 1.0F) * along;
    if (dot(offset - nearest, offset - nearest) > beyond) {
      return false; // most are
    }
    bool is_in_the_way = false;
    for (int i = 0; i <= steps && !is_in_the_way; ++i) {
      const Vector3 place = a + (static_cast<float>(i) / static_cast<float>(steps)) * along;
      is_in_the_way = distance(points_[v], place) < clearance_;
    }
    return is_in_the_way;
  });
  return is_met && !is_crowded;
}

} // namespace symmetry
} // namespace pcl
