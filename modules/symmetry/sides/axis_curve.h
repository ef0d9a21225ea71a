/** \file
 * \brief The symmetry axis curve: ordered lines along which the two sides meet (paper, section 3.3).
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Traces the line between the two sides.
 *
 * On a mesh that is the zero line of the side function through the triangles: it closes on itself or ends at a boundary
 * (or where more than two triangles share an edge). On a cloud it is the middle of the band of axis vertices. Every
 * vertex of a polyline is labelled Side::Axis, consecutive ones are neighbours in the graph, none comes twice. Parts
 * shorter than 5 % of the longest are left out. Cost O(n log n).
 * \param[in] graph of the surface
 * \param[in] triangles faces; empty for a cloud
 * \param[in] side_function as absorbSpecks () returns it: no value is zero
 * \param[in] sides the labels that belong to it
 * \return longest first; empty where there is only one side
 */
std::vector<Polyline>
traceAxis(const SurfaceGraph& graph,
          const std::vector<Triangle>& triangles,
          const std::vector<float>& side_function,
          const std::vector<Side>& sides);

} // namespace symmetry
} // namespace pcl
