/** \file
 * \brief The map of a surface that a mirror plane makes.
 */
#pragma once

#include "symmetry/mirror/plane_reflection.h"
#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Where the mirror images of the points of a surface come to lie; arrays have one entry per point. */
struct MirrorMap {
  std::vector<Index> partners; ///< the point nearest to the image; no_index where none is near
  std::vector<float> gaps;     ///< distance of the image from its partner; the reach where there is none
};

/** \brief Maps every point to the one nearest to its mirror image.
 *
 * Of a surface in parts each part is mapped onto the one that most of its images lie on, itself or its twin, where at
 * least half of them do: a leg that ends within a seat goes to the other leg and not to the seat. Where two sheets lie
 * close together, the normals of the image decide; they count up to sign, as the parts of an object often face different
 * ways.
 *
 * \param[in] tolerance distance within which an image lies on a part
 * \param[in] reach distance beyond which a point is no partner
 */
MirrorMap
mapByMirror(const PreparedSurface& surface, const PlaneReflection& plane, float tolerance, float reach);

} // namespace symmetry
} // namespace pcl
