/** \file
 * \brief The symmetry of a surface that is its own mirror image as it stands in space.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/mirror/plane_search.h"
#include "symmetry/refine/sample_refinement.h"
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

/** \brief Planes in which the surface is its own mirror image, see findMirrorPlanes (). */
std::vector<MirrorFit>
mirrorPlanesOf(const SampledSurface& sampled, const MirrorSettings& settings);

/** \brief The same of a cloud that has not been sampled yet. */
std::vector<MirrorFit>
mirrorPlanesOf(const PreparedSurface& cloud, std::size_t samples, const MirrorSettings& settings);

/** \brief Whether several planes fit as well as the best one: hypotheses and scores would take one by chance. */
bool
haveEqualFits(const std::vector<MirrorFit>& planes);

/** \brief Whether the reflection in a plane leaves no piece of the surface, large enough to be a part, without a counterpart. */
bool
carriesAll(const MirrorFit& fit, const SampledSurface& sampled, const MirrorSettings& settings);

/** \brief How a map of the samples that was found otherwise compares with that of a plane. */
struct PlaneComparison {
  bool contradicts = false; ///< what the plane carries onto the surface goes elsewhere
  /** What the plane carries onto the surface the map moves much farther, on average: the plane exchanges the faces of a
   * sheet, or front and back. */
  bool moves_farther = false;
  bool exchanges = false; ///< most of the rest has a counterpart: it changes places, as the limbs of a posed body do
  /** The rest is the same in another pose, as a head that is turned or a leg that is raised: it changes places, or some of it
   * goes to the rest on the other side of the plane, and every piece is rooted where the plane carries such a root, see
   * areRootedAlike (). */
  bool is_pose = false;
  bool keeps_rest = false; ///< most of the rest goes to the rest: the map has no other use for it
};

PlaneComparison
compareWithPlane(const SampledSurface& sampled,
                 const SampleEstimate& samples,
                 const MirrorFit& fit,
                 const MirrorSettings& settings);

/** \brief The map that the first of several mirror planes makes, with the others as alternatives and the rotations that
 * it makes with them.
 *
 * The confidence is the share of the area that comes to lie on the surface. Connected pieces that do not, from half a per
 * cent of the area on (SupportSettings::least_area), are said to have no counterpart.
 * \param[in] planes at least one, see mirrorPlanesOf () */
MapEstimate
estimateByMirror(const SampledSurface& sampled,
                 const std::vector<MirrorFit>& planes,
                 const SymmetryParameters& parameters,
                 const MirrorSettings& settings);

} // namespace symmetry
} // namespace pcl
