/** \file
 * \brief Geodesic discs of the samples of a surface.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A sample of a patch, weighted down towards the rim. */
struct PatchMember {
  Index sample;
  float weight; ///< (1 - (d / radius)^2)^2 at distance d from the centre
};

/** \brief Samples within a geodesic radius of one, lowest number first: as farthest-point samples come in an order in
 * which the first ones cover the surface evenly, so do the first ones of a patch. */
using SurfacePatch = std::vector<PatchMember>;

SurfacePatch
patchAround(const CoarseSurface& coarse, Index centre, float radius);

} // namespace symmetry
} // namespace pcl
