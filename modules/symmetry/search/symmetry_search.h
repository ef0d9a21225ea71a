/** \file
 * \brief The search for the global symmetric map among the landmarks of a surface: many hypotheses in, ranked maps out.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/map_score.h"
#include "symmetry/search/symmetry_hypotheses.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Settings of the search; every ingredient can be switched off for an ablation. */
struct SearchSettings {
  bool sign_patterns = true;
  std::size_t pairings = 60; ///< hypotheses from extremities, 0: none
  ScoreWeights score;
  std::size_t coarse_queries = 120; ///< landmarks matched per hypothesis,
  std::size_t coarse_targets = 300; ///< among so many
  /** How far these are apart, share of the diameter: the 600 landmarks are by 0.06, half of them by sqrt (2) times that. What
   * moves less stays where it is; without it the midline counts as if it did not move at all, and right hypotheses are
   * dropped. With 0.03 and 0.1 as many models are right. */
  float coarse_resolution = 0.085F;
  std::size_t refined = 16;                    ///< distinct candidates that are refined
  std::vector<int> levels{14, 18, 24, 32, 40}; ///< eigenfunctions used by the refinement
  DescriptorWeights guide{10, 0.5F, 0.3F};     ///< of the local parts that guide the refinement
  float guidance = 0.5F;                       ///< weight of the local parts of the descriptor in the refinement
  std::size_t rederived = 6; ///< best candidates whose weak parts are derived anew from their strong ones
  std::size_t regrown = 2;   ///< best candidates whose parts that are not turned over are grown anew from those around
  float distinct = 0.06F;    ///< maps that differ less on average (share of the diameter) count as one
};

/** \brief A refined map of the landmarks. */
struct SymmetryCandidate {
  SampleMap map;          ///< partner of every landmark
  Eigen::MatrixXf matrix; ///< its action on the eigenfunctions
  MapScore score;
};

/** \brief Distinct candidates, best first; empty where the surface is too small for the search. */
std::vector<SymmetryCandidate>
searchSymmetries(const SampledSurface& sampled, const SearchSettings& settings);

} // namespace symmetry
} // namespace pcl
