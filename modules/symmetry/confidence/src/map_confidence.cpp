#include "symmetry/confidence/map_confidence.h"

#include "base/statistics.h"
#include "symmetry/confidence/calibration.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl {
namespace symmetry {

namespace {

float
logistic(float evidence)
{
  return 1.0F / (1.0F + std::exp(-evidence));
}

constexpr MapCalibration map_calibration;
constexpr CandidateCalibration candidate_calibration;
constexpr ScoreCalibration score_calibration;
constexpr HoleCalibration hole_calibration;

/** How much of the evidence against a map comes from how badly the surface is known, and not from the map. */
float
evidenceFromGaps(const MapEvidence& evidence)
{
  const MapCalibration& c = map_calibration;
  const float gaps = std::clamp(
      (evidence.spacing.irregularity - c.even_irregularity) / (random_irregularity - c.even_irregularity), 0.0F, 1.0F);
  return c.gaps * gaps * std::log(std::max(1.0F, evidence.spacing.sparse / c.usual_spacing)) +
         weightOfHoles(evidence.at_holes) + (evidence.is_noisy ? c.noise : 0.0F);
}

bool
isSymmetry(const MapScore& score)
{
  return scoreConfidence(score) >= 0.5F && score.curvature <= score_calibration.curvature_bound &&
         score.distorted <= score_calibration.distorted_bound;
}

} // namespace

float
scoreConfidence(const MapScore& score)
{
  return logistic(-score_calibration.slope * (score.value - score_calibration.even));
}

bool
isReflection(const MapScore& score)
{
  return isSymmetry(score) && score.reversal >= score_calibration.least_reversal;
}

bool
isRotation(const MapScore& score)
{
  return isSymmetry(score) && score.reversal <= score_calibration.least_reversal;
}

float
candidateConfidence(const MapScore& score, const AsymmetryMeasures& measures)
{
  const CandidateCalibration& c = candidate_calibration;
  // The involution normalises: where samples are coarse or noisy, it grows together with the stretch.
  return logistic(
      c.bias + c.involution * std::log(measures.involution + c.floor) +
      c.stretch * std::log(measures.stretch + c.floor) + c.concentration * std::log(measures.concentration + c.floor) +
      c.curvature * std::log(measures.curvature + c.curvature_floor) + c.fixed * std::min(score.fixed, c.fixed_bound));
}

float
mapConfidence(const MapEvidence& evidence)
{
  const MapCalibration& c = map_calibration;
  const AsymmetryMeasures& measures = evidence.measures;
  const float distorted_beyond = std::max(0.0F, evidence.score.distorted - c.usually_distorted);
  const float fixed_beyond = std::clamp(evidence.score.fixed, c.usually_fixed, c.fixed_bound) - c.usually_fixed;
  return logistic(c.bias + c.stretch * std::log(measures.stretch + c.stretch_floor) +
                  c.worst_distance * std::log(evidence.worst_distance + c.distance_floor) +
                  c.fit_distance * std::log(evidence.fit.distance + c.fit_floor) +
                  c.turn * (std::log(std::min(evidence.fit.turn, c.turn_bound) + c.turn_floor) -
                            std::log(std::max(1.0F, evidence.fit.turn / c.turn_bound))) +
                  c.average_distance * std::log(std::min(measures.average_distance, c.average_distance_bound) +
                                                c.average_distance_floor) +
                  c.involution * std::log(std::min(measures.involution, c.involution_bound) + c.involution_floor) +
                  c.curvature * std::min(evidence.rough_curvature, c.curvature_bound) + c.fixed * fixed_beyond +
                  c.distorted * distorted_beyond + evidenceFromGaps(evidence));
}

float
confidenceBound(const MapSummary& map)
{
  return std::clamp(std::min(1.0F - map.torn_faces, 0.5F + 0.5F * map.involution), 0.0F, 1.0F);
}

float
weightOfHoles(float at_holes)
{
  const HoleCalibration& c = hole_calibration;
  return std::clamp((at_holes - c.few_holes) / (c.many_holes - c.few_holes), 0.0F, 1.0F);
}

std::pair<std::size_t, float>
bestTrustedMap(const std::vector<RatedMap>& maps, float least)
{
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const float confidence = maps[i].confidence * std::exp(2.0F * (maps[0].value - maps[i].value));
    if (confidence >= least) {
      return {i, confidence};
    }
  }
  return {0, maps[0].confidence};
}

bool
isStrongEvidence(float confidence, float than)
{
  constexpr float strong = 10.0F;
  const auto odds = [](float p) {
    return p / std::max(1e-6F, 1.0F - p);
  };
  return odds(confidence) >= strong * odds(than);
}

} // namespace symmetry
} // namespace pcl
