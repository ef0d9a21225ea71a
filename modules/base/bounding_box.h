/** \file
 * \brief Boxes along the axes.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The smallest box along the axes around all points that it was extended by; at first around none, with its
 * lower corner above the upper one. Measures are in double: coordinates may be huge. */
struct BoundingBox {
  Vector3 low{infinity, infinity, infinity};
  Vector3 high{-infinity, -infinity, -infinity};

  void
  extend(const Vector3& p)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }

  /** \brief Negative around no point. */
  double
  longestSide() const
  {
    return std::max({side(0), side(1), side(2)});
  }

  /** \brief 0 around no point. */
  double
  diagonal() const
  {
    return low[0] > high[0] ? 0.0 : std::sqrt(side(0) * side(0) + side(1) * side(1) + side(2) * side(2));
  }

  std::array<double, 3>
  centre() const
  {
    return {0.5 * (double{low[0]} + double{high[0]}), 0.5 * (double{low[1]} + double{high[1]}),
            0.5 * (double{low[2]} + double{high[2]})};
  }

  /** \brief Along the axis on which a point is farthest away; not above 0 inside. */
  double
  distanceTo(const Vector3& p) const
  {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      farthest = std::max({farthest, double{low[k]} - double{p[k]}, double{p[k]} - double{high[k]}});
    }
    return farthest;
  }

  /** \brief As the crow flies; 0 inside. */
  double
  straightDistanceTo(const Vector3& p) const
  {
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double beyond = std::max({0.0, double{low[k]} - double{p[k]}, double{p[k]} - double{high[k]}});
      squared += beyond * beyond;
    }
    return std::sqrt(squared);
  }

private:
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  double
  side(std::size_t k) const
  {
    return double{high[k]} - double{low[k]};
  }
};

inline BoundingBox
boundingBox(const std::vector<Vector3>& points)
{
  BoundingBox box;
  for (const Vector3& p : points) {
    box.extend(p);
  }
  return box;
}

} // namespace symmetry
} // namespace pcl
