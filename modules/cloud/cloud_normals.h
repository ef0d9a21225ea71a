/** \file
 * \brief Normals of a point cloud, and one orientation for all of them.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Unit normal of the plane through each point's neighbours (principal component analysis), of either sign.
 *
 * A neighbour counts less the farther away it is. Where the neighbours span no plane the normal is some vector at right
 * angles to what they span. Cost O(n k). */
std::vector<Vector3>
estimateNormals(const std::vector<Vector3>& points, const NeighbourLists& neighbours);

/** \brief Turns normals so that neighbours agree.
 *
 * Signs spread along a minimum spanning tree of the graph (H. Hoppe et al.: Surface reconstruction from unorganized
 * points, 1992 \cite hoppe1992surface) that prefers edges between parallel normals and along the surface; across an
 * edge the normal is mirrored in the plane that halves it. Every component starts with the point farthest from the
 * centroid, whose normal is turned away from it; where some normals are oriented already, the trees start with these.
 * \param[in] is_oriented per normal, or empty: none is */
void
orientNormals(const std::vector<Vector3>& points,
              const SurfaceGraph& graph,
              const std::vector<char>& is_oriented,
              std::vector<Vector3>& normals);

} // namespace symmetry
} // namespace pcl
