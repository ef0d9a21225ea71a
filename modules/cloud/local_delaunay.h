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
 * surface that is nearly a manifold. Triangles are counter-clockwise about their normals. Cost O(n k^2).
 *
 * \param[in]
 * graph neighbours to triangulate among
 */
std::vector<Triangle>
localDelaunayTriangles(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph);

/** \brief Triangles around some of the points, of which no two lie on the same side of an edge.
 *
 * Where four points lie on a circle, as on a lattice, their fans need not agree on a diagonal: triangles that several
 * corners propose come first, then those of shorter sides, and those whose place is taken are left out. Cost O(n k^2).
 * \param[in] around points whose fans are used */
std::vector<Triangle>
conformingTriangles(const std::vector<Vector3>& points,
                    const std::vector<Vector3>& normals,
                    const SurfaceGraph& graph,
                    const std::vector<Index>& around);

/** \brief Discrete Laplacian of a cloud of evenly spread samples. */
struct FanLaplacian {
  std::vector<float> conductances; ///< per edge of the graph, the same both ways, not negative
  std::vector<float> areas;        ///< per sample; they sum up to 1
  std::vector<Triangle> triangles; ///< of all fans, each once, oriented by the normals; they may overlap
};

/** \brief Cotangent weights of the local Delaunay fans: each sample triangulates its neighbours in its tangent plane;
 * an edge conducts the mean of what the fans at its two ends say, so no consistent triangulation is needed.
 *
 * N. Sharp and K. Crane: A Laplacian for nonmanifold triangle meshes. Computer Graphics Forum 39(5), 2020 (the point
 * cloud case). \cite sharp2020laplacian
 *
 * \param[in] graph joins each sample to its Delaunay neighbours at least */
FanLaplacian
localDelaunayLaplacian(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph);

} // namespace symmetry
} // namespace pcl
