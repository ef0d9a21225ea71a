#include "picture/upright.h"

#include "base/centroid.h"
#include "base/vector_math.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

// Chosen by hand on 54 meshes of TOSCA, KIDS and posed bodies, with none left out; a model of this rule has 41 of them upright.
// The others run, leap or lie.
constexpr float ground = 0.04F;    ///< of the height: what is that low touches the ground
constexpr float on_axis = 0.12F;   ///< of the half width: nearer to the mirror plane is on it
constexpr float sideways = 0.5F;   ///< cosine to the lateral direction above which an axis is not upright
constexpr float usual_axis = 0.5F; ///< what the third axis, and heads that point down, are worth less
constexpr float tallness = 0.3F;   ///< what the height is worth over the largest extent

/** \brief What lies between the least and the largest of some numbers. */
struct Range {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();

  void
  add(float value)
  {
    least = std::min(least, value);
    most = std::max(most, value);
  }

  /** \brief How far a number is outside. */
  float
  beyond(float value) const
  {
    return std::max({0.0F, least - value, value - most});
  }

  float
  length() const
  {
    return most - least;
  }
};

Range
rangeAlong(const std::vector<Vector3>& points, const Vector3& direction)
{
  Range range;
  for (const Vector3& p : points) {
    range.add(dot(p, direction));
  }
  return range;
}

/** \brief How well a body stands: the share of what touches the ground that is off the mirror plane, less how far the
 * centre is from above it, over the height. */
float
standing(const std::vector<Vector3>& points, const Vector3& lateral, const Vector3& up)
{
  const Vector3 centre = centroid(points);
  const Vector3 forward = cross(lateral, up);
  const Range heights = rangeAlong(points, up);
  const Range widths = rangeAlong(points, lateral);
  Range touched_lateral;
  Range touched_forward;
  float touching = 0.0F;
  float off_axis = 0.0F;
  for (const Vector3& p : points) {
    if (dot(p, up) > heights.least + ground * heights.length()) {
      continue;
    }
    touched_lateral.add(dot(p, lateral));
    touched_forward.add(dot(p, forward));
    touching += 1.0F;
    off_axis += std::abs(dot(p - centre, lateral)) > 0.5F * on_axis * widths.length() ? 1.0F : 0.0F;
  }
  const float overhang = touched_lateral.beyond(dot(centre, lateral)) + touched_forward.beyond(dot(centre, forward));
  return off_axis / touching - (heights.length() > 0.0F ? overhang / heights.length() : 0.0F);
}

} // namespace

Vector3
uprightDirection(const std::vector<Vector3>& points, const Vector3& lateral)
{
  Vector3 best = {0.0F, 0.0F, 0.0F};
  if (points.empty()) {
    return best;
  }
  float extent = 0.0F;
  for (const Vector3& axis : {Vector3{1.0F, 0.0F, 0.0F}, Vector3{0.0F, 1.0F, 0.0F}, Vector3{0.0F, 0.0F, 1.0F}}) {
    extent = std::max(extent, rangeAlong(points, axis).length());
  }
  float best_worth = -std::numeric_limits<float>::infinity();
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}, std::size_t{0}}) {
    for (const float sign : {1.0F, -1.0F}) {
      Vector3 axis = {0.0F, 0.0F, 0.0F};
      axis[k] = sign;
      if (std::abs(dot(axis, lateral)) > sideways) {
        continue;
      }
      const Vector3 up = normalized(axis - dot(axis, lateral) * lateral);
      const float stands = standing(points, lateral, up);
      const float unusual = k == 0 || sign < 0.0F ? usual_axis : 0.0F;
      const float height = extent > 0.0F ? rangeAlong(points, up).length() / extent : 0.0F;
      const float worth = stands + tallness * height - unusual;
      if (worth > best_worth) {
        best_worth = worth;
        best = up;
      }
    }
  }
  return best;
}

} // namespace symmetry
} // namespace pcl
