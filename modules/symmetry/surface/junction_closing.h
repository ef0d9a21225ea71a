/** \file
 * \brief Sides of a mesh that a vertex of another face lies on.
 */
#pragma once

#include "symmetry/surface/open_sides.h"
#include "symmetry/surface/prepared_surface.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Cuts triangles at the vertices that lie on their open sides, where the surface would be torn: beside a triangle
 * that was split its neighbour was not.
 *
 * What is farther off than a hundredth of a side is a gap. Of two sheets close together none is cut, and none where a
 * tip touches a side that its own sides do not run along.
 *
 * \param[in,out] surface a mesh without repeated points; triangles that are not cut stay as they are
 * \param[in] sides the open ones of its triangles
 * \return number of vertices that became corners of the triangle beside them */
std::size_t
closeJunctions(PreparedSurface& surface, const std::vector<OpenSide>& sides);

} // namespace symmetry
} // namespace pcl
