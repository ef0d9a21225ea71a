/** \file
 * \brief Nearest neighbours by PCL's kd-tree.
 */
#pragma once

#include "geodesic/neighbour_graph.h"

namespace pcl {
namespace symmetry {

/** \brief The k nearest points of every point, by pcl::search::KdTree (FLANN), on \a threads threads (0: all cores).
 * \param[in] points all finite */
NeighbourLists
searchByKdTree(const std::vector<Vector3>& points, int k, unsigned threads);

} // namespace symmetry
} // namespace pcl
