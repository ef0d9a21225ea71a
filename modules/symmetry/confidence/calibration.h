/** \file
 * \brief The numbers that turn measures of a map into its confidence, together in one place.
 *
 * Origin of all of them unless another is given: fitted by hand to right and wrong maps of generated bodies and of
 * scans, whole and with a limb cut off, as meshes and as clouds. performance/calibrate_confidence.py repeats the fit
 * openly and judges it on sets left out: it ranks maps as well as these weights do (see BENCHMARK.md), which are kept.
 * They are shares of the diameter or have no unit.
 */
#pragma once

namespace pcl {
namespace symmetry {

/** \brief Weights of mapConfidence () in its logistic function, and the floors and bounds of its measures. */
struct MapCalibration {
  float bias = -10.3F;

  float stretch = -3.2F;        ///< weight of log (AsymmetryMeasures::stretch + floor)
  float stretch_floor = 0.01F;  ///< sampling noise of 600 landmarks
  float worst_distance = -1.5F; ///< weight of log (worst_distance + floor)
  float distance_floor = 4e-3F; ///< a quarter of the spacing of 1,500 samples
  float fit_distance = -3.0F;   ///< weight of log (PatchFit::distance + floor)
  float fit_floor = 1e-3F;      ///< keeps the logarithm finite
  float curvature = -2.0F;      ///< weight of the curvature before refinement
  float curvature_bound = 1.5F;
  float fixed = -25.6F;           ///< weight of the share that stands still beyond what is usual
  float usually_fixed = 0.2F;     ///< the head, tail and seam of an animal
  float fixed_bound = 0.35F;      ///< with limbs in contact
  float distorted = -10.0F;       ///< weight of the distorted share beyond what is usual
  float usually_distorted = 0.2F; ///< limbs bent or in contact

  // These grow with the coarseness of the samples and with a pose: they normalise the rest. Beyond their bounds they
  // explain nothing more: no right map of the benchmark has as much (the largest of 428, of meshes and clouds: 0.146,
  // 0.178, 0.059; from meshes alone they were lower and refused clouds in contact). Normals that differ by more are a misfit, and count against a map as they counted for it before.
  float turn = 1.3F;             ///< weight of log (PatchFit::turn + floor)
  float turn_floor = 0.005F;     ///< normals 6 degrees apart
  float turn_bound = 0.15F;      ///< normals 32 degrees apart
  float average_distance = 1.3F; ///< weight of log (AsymmetryMeasures::average_distance + floor)
  float average_distance_floor = 4e-3F;
  float average_distance_bound = 0.18F;
  float involution = 1.5F;        ///< weight of log (AsymmetryMeasures::involution + floor)
  float involution_floor = 1e-3F; ///< keeps the logarithm finite
  float involution_bound = 0.06F;

  // What is badly known explains part of the misfit.
  float gaps = 1.2F;              ///< weight of gaps between points at random places
  float usual_spacing = 0.011F;   ///< of the points of a cloud: half the spacing of 1,500 samples
  float even_irregularity = 1.4F; ///< of evenly spread points, see PointSpacing
  float noise = 0.7F;             ///< added for a cloud that had to be smoothed
};

/** \brief Weights of candidateConfidence (); fitted by hand to generated bodies. */
struct CandidateCalibration {
  float bias = 1.0F;
  float involution = 3.1F;
  float stretch = -5.7F;
  float concentration = -1.7F;
  float curvature = -3.4F;
  float fixed = -5.0F;
  float floor = 1e-3F; ///< of the logarithms
  float curvature_floor = 0.1F;
  float fixed_bound = 0.35F; ///< the head, tail and trunk of an animal; more is for the score to judge
};

/** \brief Weights of pointConfidences () in its logistic function, and the floors of its measures.
 *
 * Origin: fitted by performance/calibrate_point_confidence.py to meshes and clouds of all sets of the benchmark; judged
 * on sets left out (see BENCHMARK.md). The floors are sampling noise. */
struct PointCalibration {
  float bias = -6.05F;
  float map = 0.31F; ///< weight of the logarithm of the odds of the map
  float map_floor = 1e-3F;
  float local_change = -0.69F; ///< weight of log (local change + floor)
  float local_floor = 0.03F;
  float fit_distance = -1.25F; ///< weight of log (distance + floor)
  float fit_floor = 1e-3F;
  float reversal = 2.06F; ///< weight of the reversal, -1 to 1
};

/** \brief Where a score alone tells right from wrong.
 *
 * The score at which it is even was set by hand, to -0.6, and has moved with the scores themselves: since these have the
 * mean of the logarithm of the displacement in them, those of right maps are higher by 0.60 in the median (refined maps of
 * meshes; half of them by 0.51 to 0.72). It was not fitted anew. */
struct ScoreCalibration {
  float even = 0.0F; ///< MapScore::value at which right and wrong are equally likely
  float slope = 4.0F;
  float curvature_bound = 0.9F;  ///< more differs over most of the surface
  float distorted_bound = 0.25F; ///< a quarter of the landmarks: a limb
  float least_reversal = 0.4F;   ///< thin limbs hold hardly a triangle whose orientation can be told
};

/** \brief Confidence below which a map is no symmetry; chosen by hand but for the last. */
struct RefusalCalibration {
  float one_interpretation = 0.35F;
  float several_interpretations = 0.25F; ///< whose maps have been compared
  float uncertain = 0.15F;               ///< where noise or gaps between the points make each of them uncertain
  float partial = 0.5F;                  ///< that a part has no counterpart is said where it is more likely than not
};

/** \brief How many samples at holes explain part of what speaks against a map. */
struct HoleCalibration {
  float few_holes = 0.02F;  ///< share of the samples at holes that explains nothing
  float many_holes = 0.08F; ///< and that explains all it can
};

} // namespace symmetry
} // namespace pcl
