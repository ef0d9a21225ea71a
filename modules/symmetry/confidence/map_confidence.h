/** \file
 * \brief How far a map can be trusted: as a whole, and point by point.
 */
#pragma once

#include "symmetry/confidence/map_evidence.h"
#include "symmetry/samples/sampled_surface.h"

#include <pcl/symmetry/symmetry_result.h>

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Confidence of a map below which it is in doubt: a mesh is searched again, and a mirror plane in space, where there
 * is one, is more certain. Chosen by hand with all sets of the benchmark at hand. */
constexpr float in_doubt = 0.75F;

/** \brief Confidence from which on no other explanation is looked for. By hand. */
constexpr float beyond_doubt = 0.9F;

/** \brief How likely a map is by its score alone: a logistic function of it, in [0, 1]. */
float
scoreConfidence(const MapScore& score);

/** \brief Whether a map is good enough to be called a reflective symmetry. */
bool
isReflection(const MapScore& score);

/** \brief Whether a map, scored by scoreRotation (), is good enough to be called a symmetry that keeps the orientation.
 */
bool
isRotation(const MapScore& score);

/** \brief How likely a map of the landmarks is right before it is refined, in [0, 1]: to compare candidates.
 *
 * A logistic function of the logarithms of the measures of asymmetry and of the share of the surface that stands still:
 * an odd limb is mapped to itself. Its weights were fitted to generated bodies.
 */
float
candidateConfidence(const MapScore& score, const AsymmetryMeasures& measures);

/** \brief Confidence of a whole map in [0, 1]: how likely it is a right map of a symmetric surface.
 *
 * A logistic function of the stretch and the misfit of patches at the worst places relative to how far the whole is
 * from isometric (where an odd limb was or should be, its surroundings are stretched and do not fit; a pose or coarse
 * samples bend and stretch everything), of the curvature, and of what stands still beyond a head, a tail and a seam: an
 * odd limb is mirrored in itself. Noise, few points, or holes explain part of all that. Its weights were fitted to
 * right and wrong maps of scanned and of generated bodies, whole and with a limb cut off, as meshes, clouds, clouds
 * that are noisy, sparse and uneven, and with holes; a right map refused was counted like two wrong ones delivered.
 */
float
mapConfidence(const MapEvidence& evidence);

/** \brief How much of what speaks against a map holes may explain, in [0, 1]: nothing where hardly a sample is at one.
 * \param[in] at_holes share of the samples into whose cells holes reach */
float
weightOfHoles(float at_holes);

/** \brief What is measured on the finished map bounds its confidence from above, whatever the features say.
 *
 * A face that is torn apart has a corner whose partner is wrong; of a point and its partner from which the map does not
 * lead back one has a wrong partner at least. So no more than 1 - torn and (1 + involution) / 2 of it can be right. */
float
confidenceBound(const MapSummary& map);

/** \brief Whether one confidence has ten times the odds of another: strong evidence (H. Jeffreys, Theory of probability,
 * 1961). */
bool
isStrongEvidence(float confidence, float than);

/** \brief Share of the confidence that is left to a map that is not handed out: what spoke against it counts as well.
 */
constexpr float confidence_of_refused = 0.1F;

/** \brief One of several maps of a surface. */
struct RatedMap {
  float value;      ///< SampleEstimate::value, the lower the better
  float confidence; ///< mapConfidence ()
};

/** \brief The map to go on with where a surface may have been misread, as a cloud may: its number, and its confidence.
 *
 * A wrong contact lets the right map look bad in one place, so that a wrong one fits better and is refused. So the best
 * map that is not refused is taken; the first one if all are. The value has the logarithm of the misfit in it: a map
 * that fits worse than the first one by a factor has a confidence lower by the square of that factor.
 *
 * \param[in] maps at least one, the best first
 * \param[in] least confidence below which a map is refused */
std::pair<std::size_t, float>
bestTrustedMap(const std::vector<RatedMap>& maps, float least);

} // namespace symmetry
} // namespace pcl
