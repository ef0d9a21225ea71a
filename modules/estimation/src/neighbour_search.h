/** \file
 * \brief Nearest neighbours by PCL's kd-tree.
 */
#pragma once

#include "geodesic/neighbour_graph.h"

namespace pcl {
namespace symmetry {

/** \brief The k nearest points of every point, by pcl::search::KdTree (FLANN).
 * \param[in] points all finite */
NeighbourLists
searchByKdTree(const std::vector<Vector3>& points, int k);

} // namespace symmetry
} // namespace pcl
