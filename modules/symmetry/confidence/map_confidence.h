/** \file
 * \brief How far a map can be trusted: as a whole, and point by point.
 */
#pragma once

#include "symmetry/confidence/map_asymmetry.h"
#include "symmetry/refine/patch_alignment.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/map_score.h"

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

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

/** \brief How densely and evenly the points of a cloud lie. */
struct PointSpacing {
  /** Mean distance of a sample from its neighbours in the graph, share of the diameter; nine of ten samples have closer
   * ones. Where the points are farther apart than the samples should be, distances and patches are no more precise. */
  float sparse = 0.0F;
  /** Mean distance of a sample from its neighbours over that from the nearest one, the median sample: 1.4 where points
   * are evenly spread, about 2.3 where they lie at random and leave gaps. */
  float irregularity = 1.0F;
};

/** \brief Measures the points around the samples; samples without neighbours at a distance do not count. */
PointSpacing
measureSpacing(const SurfaceGraph& graph, const std::vector<Index>& samples, float diameter);

/** \brief Irregularity from which on the points of a cloud lie at random, or nearly so. */
constexpr float random_irregularity = 1.8F;

/** \brief What speaks for and against a refined map. */
struct MapEvidence {
  MapScore score;               ///< of the refined map
  float rough_curvature = 0.0F; ///< MapScore::curvature before: refinement lays curved places on each other if it can
  AsymmetryMeasures measures;
  PatchFit fit{0.0F, 0.0F};    ///< of the patches and their images, the mean
  float worst_distance = 0.0F; ///< of the worst of them: SampleEstimate::worst_distance
  bool is_noisy = false;       ///< the surface is that of a cloud which had to be smoothed: part of the misfit is noise
  float at_holes = 0.0F;       ///< share of the samples into whose cells holes reach
  PointSpacing spacing;        ///< of a cloud; the faces of a mesh tell what is between its points
};

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

/** \brief A reflection of lower confidence is none: one side has what the other lacks. 0.35; less where holes hide what
 * would tell, down to 0.15.
 * \param[in] known_holes share of the samples into whose cells holes reach, where faces tell */
float
leastMapConfidence(float known_holes);

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

/** \brief Confidence of every point: that of the map, lowered where distances to other samples change.
 *
 * At sample i the mean change |d (i, j) - d (m (i), m (j))| over the landmarks j, share of the diameter, divides the
 * map's confidence by 1 + (change / 5 %)^2.
 */
std::vector<float>
pointConfidences(const SampledSurface& sampled, const SampleMap& map, float map_confidence);

} // namespace symmetry
} // namespace pcl
