/** \file
 * \brief Zero lines of a function on a surface without faces.
 */
#pragma once

#include "geodesic/surface_graph.h"
#include "symmetry/sides/mesh_contour.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Lines through the places at which edges of a cloud's neighbour graph cross from one sign to the other.
 *
 * These places lie in a narrow band; those of edges that share a point, or that are near and next to each other, are
 * linked. A line is the shortest path between the two
 * places of the band that are farthest from each other; if they stay joined when a tube as wide as the band is cut out
 * around that path, a second path closes it. What is then left of the band outside the tube is searched again. Paths
 * keep to short edges: long ones may join parts that only touch.
 * \param[in] graph neighbour graph of the cloud
 * \param[in] points of the cloud
 * \param[in] values one per point; zero counts as positive
 * \return of consecutive crossings the edges share a point, or have ends that are neighbours
 */
std::vector<ZeroLine>
cloudContours(const SurfaceGraph& graph, const std::vector<Vector3>& points, const std::vector<float>& values);

/** \brief The place of a crossing. */
Vector3
placeOf(const ZeroCrossing& crossing, const std::vector<Vector3>& points);

} // namespace symmetry
} // namespace pcl
