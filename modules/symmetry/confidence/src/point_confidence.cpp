#include "symmetry/confidence/point_confidence.h"

#include "symmetry/confidence/calibration.h"
#include "symmetry/search/map_regrowth.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr PointCalibration calibration;

float
logistic(float evidence)
{
  return 1.0F / (1.0F + std::exp(-evidence));
}

/** Logarithm of the odds; of a map that is all but certain, or all but impossible, no more than is ever known. */
float
logOdds(float confidence, float least)
{
  const float bounded = std::clamp(confidence, least, 1.0F - least);
  return std::log(bounded / (1.0F - bounded));
}

float
fromMap(float map_confidence)
{
  return calibration.map * logOdds(map_confidence, calibration.map_floor);
}

} // namespace

std::vector<PointEvidence>
pointEvidence(const SampledSurface& sampled, const SampleEstimate& samples, const std::vector<float>& local_changes)
{
  const std::vector<float> reversals = reversalAtLandmarks(sampled.landmarks, samples.landmark_map);
  std::vector<PointEvidence> evidence(sampled.landmarks.size());
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    evidence[i] = {local_changes[i], samples.fits[i].distance, reversals[i]};
  }
  return evidence;
}

std::vector<float>
pointConfidences(const SampledSurface& sampled, const std::vector<PointEvidence>& evidence, float map_confidence)
{
  const PointCalibration& c = calibration;
  const float common = c.bias + fromMap(map_confidence);
  std::vector<float> at_samples(sampled.coarse.size());
  for (std::size_t i = 0; i < at_samples.size(); ++i) {
    const PointEvidence& here = evidence[sampled.landmarks.nearest_landmark[i]];
    at_samples[i] = common + c.local_change * std::log(here.local_change + c.local_floor) +
                    c.fit_distance * std::log(here.fit_distance + c.fit_floor) + c.reversal * here.reversal;
  }
  std::vector<float> confidences(sampled.surface.size());
  for (std::size_t v = 0; v < confidences.size(); ++v) {
    confidences[v] = logistic(sampled.interpolation.at(v, at_samples));
  }
  return confidences;
}

float
withMapConfidence(float point_confidence, float before, float after)
{
  constexpr float finite = 1e-6F;
  if (point_confidence <= 0.0F) { // of what has no partner
    return 0.0F;
  }
  return logistic(logOdds(point_confidence, finite) + fromMap(after) - fromMap(before));
}

} // namespace symmetry
} // namespace pcl
