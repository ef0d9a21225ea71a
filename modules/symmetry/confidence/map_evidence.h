/** \file
 * \brief All that is measured on a refined map and speaks for or against it.
 */
#pragma once

#include "symmetry/confidence/map_asymmetry.h"
#include "symmetry/confidence/support.h"
#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/map_score.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

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
  float local_change = 0.0F;   ///< LocalDistanceChange at the median landmark
  float worst_local_change = 0.0F;  ///< at 97 % of the landmarks
  float turn = 0.0F;                ///< PatchFit::turn of the median patch
  std::vector<float> local_changes; ///< LocalDistanceChange of every landmark
  float worst_turn = 0.0F;          ///< of 97 % of the patches
};

/** \brief Measures a refined map.
 * \param[in] candidate that was refined
 * \param[in] spacing of the points of a cloud, see measureSpacing () */
MapEvidence
gatherEvidence(const SampledSurface& sampled,
               const SymmetryCandidate& candidate,
               const SampleEstimate& samples,
               const PointSpacing& spacing);

/** \brief Measures a refined map on the supported part of the surface alone: what has no counterpart neither counts
 * itself nor do distances to it, nor what it disturbs.
 * \param[in] whole gatherEvidence () of the map
 * \param[in] support with some part that is unsupported */
MapEvidence
gatherSupportedEvidence(const SampledSurface& sampled,
                        const SymmetryCandidate& candidate,
                        const SampleEstimate& samples,
                        const Support& support,
                        const MapEvidence& whole);

/** \brief Share of the samples into whose cells holes reach. */
float
shareAtHoles(const CoarseSurface& coarse);

/** \brief Every measure with its name, for tables. */
std::vector<std::pair<std::string, float>>
namedMeasures(const MapEvidence& evidence);

} // namespace symmetry
} // namespace pcl
