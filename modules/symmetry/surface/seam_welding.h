/** \file
 * \brief Seams of a mesh whose two sides agree but for the last digits.
 */
#pragma once

#include "symmetry/surface/open_sides.h"
#include "symmetry/surface/prepared_surface.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Lets the lowest of several corners at one place, but for rounding, stand for all: where patches were written
 * one by one, the last meridian of a body of revolution is computed anew, or facets have corners of their own, the
 * surface is torn there.
 *
 * Only corners on open sides are welded, and only within a hundredth of the shortest side around them: what is farther
 * apart is a gap. Where the faces of one corner lie over those of the other these are two sheets close together, which
 * stay two. What is nearest is welded first. Cost O(n log n), for a closed mesh O(n).
 *
 * \param[in,out] surface a mesh without repeated points; its triangles are renumbered, and may become degenerate
 * \param[in] sides the open ones of its triangles
 * \return number of points that another stands for now */
std::size_t
weldSeams(PreparedSurface& surface, const std::vector<OpenSide>& sides);

} // namespace symmetry
} // namespace pcl
