/** \file
 * \brief The robust method: many hypotheses of the global map, scored, refined in a Laplacian basis, chosen.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/map_judgement.h"
#include "symmetry/mirror_method.h"
#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/limb_exchange.h"
#include "symmetry/search/symmetry_search.h"
#include "symmetry/step_timer.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <functional>
#include <limits>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What the robust method is made of; the defaults are those of the class. */
struct RobustSettings {
  SamplingSettings sampling;
  MirrorSettings mirror;
  SearchSettings search;
  RefinementSettings refinement;
  LimbExchangeSettings exchange;
  std::size_t contenders = 4;       ///< best candidates that are refined and compared, as long as their scores
  float contender_margin = 0.7F;    ///< are not worse than the best one's by more than this: half as isometric
  std::size_t later_contenders = 2; ///< the same beside maps of other interpretations, which are refined as well
  /** A search whose best candidate has no better score (MapScore::value) has found nothing: no map is refined. */
  float score_to_beat = std::numeric_limits<float>::infinity();
  /** Shown all refined maps, the one that is taken first; none where a mirror plane explains the surface. May be empty. */
  std::function<void(const SampledSurface&, const std::vector<Contender>&)> observer;
};

/** \brief The defaults with as many samples as are asked for, or a share of them, but no fewer than minimum_samples. */
RobustSettings
robustSettings(const SymmetryParameters& parameters, float samples = 1.0F);

/** \brief Finds the symmetric map of any connected surface.
 *
 * Status TooFewPoints below 60 points, NoSymmetry where no candidate explains the surface as a reflection.
 * \param[in] surface connected, at unit scale
 * \param[in] parameters metric, alternatives (none with sparse_only)
 * \param[in] settings ingredients
 * \param[in] known maps that other interpretations of the surface have led to, partner of each point or no_index: they are
 * tried as well
 * \param[in,out] timer told of the steps sampling, embedding, geodesics, features, hypotheses, matching, dense
 * \throws Cancelled by the timer
 */
MapEstimate
estimateRobust(const PreparedSurface& surface,
               const SymmetryParameters& parameters,
               const RobustSettings& settings,
               StepTimer& timer,
               const std::vector<std::vector<Index>>& known = {});

} // namespace symmetry
} // namespace pcl
