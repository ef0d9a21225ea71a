/** \file
 * \brief Points of a cloud that are on no surface.
 */
#pragma once

#include "geodesic/neighbour_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Mean distance of every point to its neighbours. */
std::vector<float>
neighbourDistances(const std::vector<Vector3>& points, const NeighbourLists& lists);

/** \brief Marks outliers.
 *
 * They are points much farther from their neighbours than these are from theirs (a simple local outlier factor, M.
 * Breunig et al., 2000 \cite breunig2000lof), so that uneven density is none. Where there are so many that each has
 * others around it, they are also those far apart that fill space instead of a plane, and what has hardly any other
 * neighbours; beside the surface, those off the plane of neighbours that have nearer ones themselves. Not so in a noisy
 * cloud, which fills space everywhere.
 *
 * \param[in] distances see neighbourDistances () */
std::vector<char>
findOutliers(const std::vector<Vector3>& points, const NeighbourLists& lists, const std::vector<float>& distances);

} // namespace symmetry
} // namespace pcl
