/** \file
 * \brief Curves along the middle of a band of vertices, for surfaces without faces.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Thins the axis band of a cloud to curves over its neighbour graph.
 *
 * A curve is the shortest path between the two vertices of the band that are farthest from each other; if they stay
 * joined when a tube as wide as the band is cut out around that path, a second path closes it. What is then left of the
 * band outside the tube is searched again. Paths keep to where the side function is small.
 * \param[in] graph neighbour graph of the cloud
 * \param[in] side_function see absorbSpecks ()
 * \param[in] sides the band are the vertices labelled Side::Axis
 */
std::vector<Polyline>
bandCurves(const SurfaceGraph& graph, const std::vector<float>& side_function, const std::vector<Side>& sides);

} // namespace symmetry
} // namespace pcl
