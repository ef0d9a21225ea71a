/** \file
 * \brief Triangles of a point cloud, from Delaunay triangulations in the tangent planes of its points.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Local Delaunay triangulation of a cloud with oriented normals.
 *
 * Every point proposes the fan of triangles around it in the Delaunay triangulation of its graph neighbours, projected
 * into its tangent plane; a triangle is kept where at least two of its three corners propose it. On an evenly sampled
 * surface that is nearly a manifold. Triangles are counter-clockwise about their normals. Cost O(n k^2). \param[in]
 * graph neighbours to triangulate among
 */
std::vector<Triangle>
localDelaunayTriangles(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph,
                       unsigned threads);

} // namespace symmetry
} // namespace pcl
