/** \file
 * \brief The symmetry axis curve: ordered lines along which the two sides meet (paper, section 3.3).
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Traces the line between the two sides.
 *
 * On a mesh that is the zero line of the side function through the triangles: it closes on itself or ends at a boundary
 * (or where more than two triangles share an edge). On a cloud it runs through the edges of the graph that cross from
 * one side to the other, evenly spaced and smoothed, and is continued over gaps (line_joining.h). Consecutive points of a
 * polyline are neighbours in the graph, but over such a gap. Parts shorter than 5 % of the longest are left
 * out. Cost O(n log n).
 * \param[in] surface its graph, its triangles unless it is a cloud, and its normals where it has any
 * \param[in] side_function as absorbSpecks () returns it: no value is zero
 * \param[in] is_out per point: not 0 where no line is wanted; may be empty
 * \return in the unit of the prepared surface, longest first; empty where there is only one side
 */
std::vector<Polyline>
traceAxis(const PreparedSurface& surface, const std::vector<float>& side_function, const std::vector<char>& is_out);

} // namespace symmetry
} // namespace pcl
