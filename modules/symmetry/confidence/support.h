/** \file
 * \brief Which parts of a surface have a counterpart under a map, and which have none.
 */
#pragma once

#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief When a place counts as unsupported. */
struct SupportSettings {
  /** Relative change of nearby distances, LocalDistanceChange, from which on a place has no counterpart: the curve of
   * fixed points leaves the middle of the body there, or what is long on one side is short on the other. A joint that
   * bends changes distances across it by up to a third (a straight leg and one bent at a right angle differ by
   * 1 - cos 45 degrees). */
  float change = 0.4F;
  float least_area = 0.005F; ///< of a connected group of such places, share of the surface: less is noise of samples
  /** Extent of a part over the side of a square of its area from which on it stands out like a limb: 0.56 of a flat
   * disc, 0.63 of a hemisphere, less of a band along which a map is torn; 1 of a tube of three diameters. The area is
   * counted in squares of the spacing of landmarks. Set after these ratios were printed of 28 surfaces; no set was left
   * out. */
  float outstanding = 1.0F;
  /** Whether the images of such places, and what is adjacent to them, are suspected, too: where changes are small, those
   * around the root of an odd limb do not close to a ring by themselves. */
  bool suspects_images = false;
  /** Share of the diameter within which a part that stands out disturbs: as far as the smallest patches reach. */
  float rim = RefinementSettings{}.patches.back().radius;
};

/** \brief The parts without a counterpart: one entry per landmark. */
struct Support {
  std::vector<char> is_unsupported; ///< of the landmark
  std::vector<char> is_disturbed;   ///< also: not unsupported, but too near to what is for its measures to count
  float unsupported_share = 0.0F;   ///< of the area
};

/** \brief Finds the parts of a surface that have no counterpart under a map.
 *
 * Nearby distances change where an odd part is rooted and where its counterpart should be, not along it: an odd limb is
 * mirrored in itself. So the groups of landmarks where they change come first; then what these cut off from the bulk of
 * the surface and the map sends into itself.
 * \param[in] local_change LocalDistanceChange of the map */
Support
findSupport(const SampledSurface& sampled,
            const SampleEstimate& samples,
            const std::vector<float>& local_change,
            const SupportSettings& settings = {});

/** \brief Takes places back that have a counterpart all the same.
 *
 * First those that the map exchanges with a place far away, there and back: where parts of a body touch, a cloud's
 * distances change on both sides of the contact, but an odd limb is sent into itself, since nothing else is left for it.
 *
 * Then those whose distances change only to what has no counterpart. Around the root of an odd limb, and where its
 * counterpart should be, distances to that limb change, but those to the rest of the surface do not: these places have counterparts, in each other. They join what is supported from its rim
 * inwards, each where its change relative to what is supported by then, and that of its partner, is small. An odd
 * limb is reached at its root alone, from which one side of the body is nearer than the other.
 *
 * What joined stays disturbed, and so is the rim around a part that stands out: the surface around the root of a limb is
 * another than where its counterpart should be.
 * \param[in,out] changes of every landmark; of those that join, relative to what is supported
 * \return the support with those that joined */
Support
takeBackSupported(const SampledSurface& sampled,
                  const SampleEstimate& samples,
                  const Support& support,
                  const SupportSettings& settings,
                  std::vector<float>& changes);

} // namespace symmetry
} // namespace pcl
