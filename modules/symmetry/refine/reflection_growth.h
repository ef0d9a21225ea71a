/** \file
 * \brief Parts of a map that are grown anew from the parts around them that fit.
 */
#pragma once

#include "symmetry/refine/patch_fitting.h"
#include "symmetry/samples/sampled_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Which patches take part and when one is replaced. */
struct GrowthSettings {
  float radius = 0.1F;       ///< geodesic, share of the diameter
  std::size_t patches = 300; ///< centred at the first samples; 0: nothing grows
  float well = 0.06F;        ///< misfit below which a patch is left alone
  float clearly = 0.7F;      ///< share of its misfit that a better reflection must come below
};

/** \brief Lets the reflections of patches that fit spread to those that do not.
 *
 * Where a hand touches a hip, distances over the surface are wrong, so is the map, and alignment of patches, which only
 * goes downhill, does not find back. But a hand goes the way of its wrist: the reflection that carries a patch onto its
 * image is tried on the patches around it and, backwards, on those around its image, and settled there; the better one
 * is kept and tried in turn. The patches that fit best come first. So good matches spread in PatchMatch (C. Barnes et
 * al., 2009 \cite barnes2009patchmatch), which has images in place of surfaces.
 * \param[in] fitting of the samples
 * \param[in,out] partners partner point of every sample
 * \return number of times that a patch got a better reflection */
std::size_t
growReflections(const SampledSurface& sampled,
                const PatchFitting& fitting,
                const GrowthSettings& settings,
                std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
