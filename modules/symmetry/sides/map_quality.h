/** \file
 * \brief Properties of a dense map, whatever method made it.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Fills in MapSummary but for the number of axis points.
 *
 * Distances for the measure of involution are straight lines, which are never longer than the geodesic ones, so it errs
 * on the side of the map by what a bend cuts short. The measure of isometry runs one shortest-path search per landmark
 * and one per partner of a landmark.
 *
 * \param[in] partners one per point, -1 where there is none
 *
 * \param[in] diameter
 * largest landmark distance, in the unit of the prepared surface
 */
MapSummary
measureMap(const PreparedSurface& surface, const std::vector<Index>& partners, float diameter);

} // namespace symmetry
} // namespace pcl
