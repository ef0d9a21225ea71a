/** \file
 * \brief Distances from a set of points on a regular grid: rough, but read in no time.
 */
#pragma once

#include "base/bounding_box.h"

#include <pcl/symmetry/surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Distance to the nearest of some points, to the precision of a cube of the grid. */
class DistanceGrid {
public:
  /** \param[in] points at least one, all finite
   * \param[in] cells along the longest side of their bounding box
   *
   * Cost O(cells^3). */
  DistanceGrid(const std::vector<Vector3>& points, std::size_t cells);

  /** \brief Distance of a place from the nearest point; outside of the grid that of the nearest cube and the way there. */
  float
  at(const Vector3& place) const;

private:
  void
  transformAlong(std::size_t axis);

  Vector3 low_{};
  float cell_ = 1.0F;
  std::array<std::size_t, 3> size_{};
  std::vector<float> squared_; ///< distances, in cubes
};

} // namespace symmetry
} // namespace pcl
