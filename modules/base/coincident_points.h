/** \file
 * \brief Points at the same place.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief For each point the first one with the same coordinates, itself where there is none before it; 0 and -0 are
 * the same, what is not a number is like nothing. Cost O(n). */
std::vector<Index>
firstCoincident(const std::vector<Vector3>& points);

} // namespace symmetry
} // namespace pcl
