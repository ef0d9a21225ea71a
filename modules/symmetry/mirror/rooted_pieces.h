/** \file
 * \brief What a mirror plane leaves out: a part that was fitted on somewhere, or one that belongs there and is posed.
 */
#pragma once

#include "symmetry/mirror/plane_reflection.h"
#include "symmetry/samples/coarse_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Whether all pieces of a surface whose mirror images do not lie on it are rooted where the plane carries such a
 * root: a head that is turned its own, a leg that is raised that of the other leg.
 *
 * The root of a piece are the samples next to it whose images do lie on the surface. That of a part that stands on one
 * side is carried to a place where nothing is rooted. Of a circle that touches another one, half of the points are farther
 * from that one than a radius (see movesRoot () in odd_limb.cpp): so images farther than one radius from all roots, in the
 * median, are another place.
 *
 * \param[in] is_off not 0 for the samples whose images do not lie on the surface
 * \param[in] least_share of the area; smaller pieces are overlooked, but for their roots
 * \return false where there is no such piece */
bool
areRootedAlike(const CoarseSurface& coarse,
               const std::vector<char>& is_off,
               const PlaneReflection& plane,
               float least_share);

} // namespace symmetry
} // namespace pcl
