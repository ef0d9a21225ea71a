/** \file
 * \brief The numbers of the staged method, together in one place: the paper's, and those that it leaves open.
 */
#pragma once

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Stages, see staged_method.h. */
struct StageSettings {
  std::size_t average_samples = 100; ///< for AGD; from the paper, section 3.1
  std::size_t kept_extremities = 5;  ///< matches of stages 1 and 2, per pair of limbs; from the paper, section 3.3
  std::size_t kept_in_stage_3 = 20;  ///< matches per mapping of regions; from the paper, section 3.3
  std::size_t kept_in_stage_4 = 30;  ///< the same
  /** Share of the diameter, about the width of two fingers; chosen by hand on generated bodies and scans; not fitted by
   * a script. */
  float extremity_separation = 0.03F;
  std::size_t minimum_points = 20; ///< chosen by hand
};

/** \brief Extreme points and their pairs, see extremities.h and extreme_pairs.h. */
struct ExtremitySettings {
  int smoothing_rounds = 1;                    ///< of AGD over 1-rings; chosen by hand
  std::size_t points_of_large_surface = 30000; ///< limit between AGD and MGD; from the paper, section 3.1
  /** Share of the largest AGD by which pairs must differ to be told apart: poses change it by 1 to 3 %. Chosen by hand
   * on generated bodies and scans; not fitted by a script. */
  float clear_step = 0.05F;
  int maximum_rounds = 4; ///< in which extremities are moved apart; chosen by hand
  /** Points among which the two pairs are sought: on animals of TOSCA, children and posed bodies the tips of all limbs
   * are among the first nine, of the first seven they are missing on one model in fourteen. */
  std::size_t candidates = 9;
  /** By how much a pose changes the sum of three such distances of true partners: 2 % of the largest distance each.
   * Anything from 2 to 15 % chooses the same pairs on these models. */
  float usual_change = 0.06F;
  std::size_t foremost_points = 6; ///< that have to have an image: head, tail and four paws are as many
};

/** \brief Trust in the result, see staged_confidence.h; lengths are shares of the diameter. Chosen by hand on generated
 * bodies and scans; not fitted by a script. */
struct StagedConfidenceSettings {
  float involution_tolerance = 0.02F; ///< within which a vertex counts as come back
  float tolerable_distortion = 0.05F; ///< at which the confidence is 1 / e: poses distort distances by 2 to 4 %
  /** Cost of the extreme pairs at which it is. With it no right map of TOSCA and posed bodies is lost at the least
   * trusted confidence; pairs of bodies that lack a limb cost 0.34 and more in nine of ten cases, those of whole ones
   * less in nineteen of twenty. */
  float tolerable_pairs = 0.8F;
  float feature_scale = 0.15F; ///< relative difference of the features at which a vertex's is 1 / e
  float return_scale = 0.1F;   ///< distance of the partner's partner at which it is 1 / e
};

} // namespace symmetry
} // namespace pcl
