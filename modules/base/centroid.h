/** \file
 * \brief Centre of gravity of points.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Mean of the points, summed up in double; not a number if there are none. */
Vector3
centroid(const std::vector<Vector3>& points);

/** \brief The point farthest from the centroid, of several the first; 0 if there are none. A start that hardly depends
 * on the order of the points. */
Index
farthestFromCentroid(const std::vector<Vector3>& points);

} // namespace symmetry
} // namespace pcl
