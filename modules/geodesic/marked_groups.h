/** \file
 * \brief Connected groups of marked points.
 */
#pragma once

#include "base/union_find.h"
#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The connected groups of the points with a mark; each of the others is alone.
 * \param[in] marks one per point of the graph, 0 for none */
UnionFind
markedGroups(const SurfaceGraph& graph, const std::vector<char>& marks);

} // namespace symmetry
} // namespace pcl
