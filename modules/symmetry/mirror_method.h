/** \file
 * \brief The symmetry of a surface that is its own mirror image as it stands in space.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/mirror/plane_search.h"
#include "symmetry/samples/sampled_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Settings of the maps that mirror planes make; lengths are shares of the diagonal of the bounding box. */
struct MirrorSettings {
  PlaneSearchSettings planes;
  float reach = 0.03F; ///< of the image of a point, within which its partner is: twice the spacing of the samples
};

/** \brief Planes in which the surface is its own mirror image but for a twentieth of its area, the best first. */
std::vector<MirrorFit>
mirrorPlanesOf(const SampledSurface& sampled, const MirrorSettings& settings);

/** \brief The same of a cloud that has not been sampled yet. */
std::vector<MirrorFit>
mirrorPlanesOf(const PreparedSurface& cloud, std::size_t samples, const MirrorSettings& settings);

/** \brief Whether several planes fit as well as the best one: hypotheses and scores would take one by chance. */
bool
haveEqualFits(const std::vector<MirrorFit>& planes);

/** \brief The map that the first of several mirror planes makes, with the others as alternatives and the rotations that
 * it makes with them.
 *
 * The confidence is the share of the area that comes to lie on the surface.
 * \param[in] planes at least one, see mirrorPlanesOf () */
MapEstimate
estimateByMirror(const SampledSurface& sampled,
                 const std::vector<MirrorFit>& planes,
                 const SymmetryParameters& parameters,
                 const MirrorSettings& settings);

} // namespace symmetry
} // namespace pcl
