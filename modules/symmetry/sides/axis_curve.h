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
 * (or where more than two triangles share an edge). On a cloud it runs through local Delaunay triangles, evenly spaced and
 * smoothed, and is continued over gaps (line_joining.h). Consecutive points of a
 * polyline are neighbours in the graph, but over such a gap. Cost O(n log n).
 * \param[in] surface its graph, its triangles unless it is a cloud, and its normals, which a cloud must have
 * \param[in] side_function no value is zero, see withoutZeros ()
 * \param[in] is_out per point: not 0 where no line is wanted; may be empty
 * \param[in] are_sides_exact whether nothing in the side function is noise: every line of a mesh is told. Of others, and
 * of clouds, only those that are at least 5 % as long as the longest
 * \return in the unit of the prepared surface, longest first; empty where there is only one side
 */
std::vector<Polyline>
traceAxis(const PreparedSurface& surface,
          const std::vector<float>& side_function,
          const std::vector<char>& is_out,
          bool are_sides_exact);

} // namespace symmetry
} // namespace pcl
