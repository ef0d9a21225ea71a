#include "symmetry/confidence/map_confidence.h"

#include "base/statistics.h"

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

/** How much of the evidence against a map comes from how badly the surface is known, and not from the map. */
float
evidenceFromGaps(const MapEvidence& evidence)
{
  constexpr float usual_spacing = 0.011F;
  constexpr float even = 1.4F;
  const float gaps = std::clamp((evidence.spacing.irregularity - even) / (random_irregularity - even), 0.0F, 1.0F);
  return 1.2F * gaps * std::log(std::max(1.0F, evidence.spacing.sparse / usual_spacing)) +
         weightOfHoles(evidence.at_holes) + (evidence.is_noisy ? 0.7F : 0.0F);
}

bool
isSymmetry(const MapScore& score)
{
  constexpr float largest_curvature = 0.9F;
  constexpr float most_distorted = 0.25F;
  return scoreConfidence(score) >= 0.5F && score.curvature <= largest_curvature && score.distorted <= most_distorted;
}

} // namespace

float
scoreConfidence(const MapScore& score)
{
  constexpr float even = -0.6F; // score at which right and wrong are equally likely
  constexpr float slope = 4.0F;
  return logistic(-slope * (score.value - even));
}

bool
isReflection(const MapScore& score)
{
  constexpr float least_reversal = 0.4F; // thin limbs hold hardly a triangle whose orientation can be told
  return isSymmetry(score) && score.reversal >= least_reversal;
}

bool
isRotation(const MapScore& score)
{
  constexpr float most_reversal = 0.4F;
  return isSymmetry(score) && score.reversal <= most_reversal;
}

float
candidateConfidence(const MapScore& score, const AsymmetryMeasures& signs)
{
  constexpr float tiny = 1e-3F;
  constexpr float little_curvature = 0.1F;
  constexpr float largest_fixed = 0.35F; // the head, tail and trunk of an animal; more is for the score to judge
  // The involution normalises: where samples are coarse or noisy, it grows together with the stretch.
  return logistic(1.0F + 3.1F * std::log(signs.involution + tiny) - 5.7F * std::log(signs.stretch + tiny) -
                  1.7F * std::log(signs.concentration + tiny) - 3.4F * std::log(signs.curvature + little_curvature) -
                  5.0F * std::min(score.fixed, largest_fixed));
}

PointSpacing
measureSpacing(const SurfaceGraph& graph, const std::vector<Index>& samples, float diameter)
{
  constexpr double most_samples = 0.9;
  std::vector<float> means;
  std::vector<float> ratios;
  for (const Index v : samples) {
    const auto begin = graph.lengths.begin() + graph.offsets[v];
    const auto end = graph.lengths.begin() + graph.offsets[v + 1];
    const float nearest = begin != end ? *std::min_element(begin, end) : 0.0F;
    if (nearest > 0.0F) { // and not too small for a float
      means.push_back(std::accumulate(begin, end, 0.0F) / static_cast<float>(end - begin));
      ratios.push_back(means.back() / nearest);
    }
  }
  if (means.empty()) {
    return {};
  }
  return {quantile(std::move(means), most_samples) / diameter, median(std::move(ratios))};
}

float
mapConfidence(const MapEvidence& evidence)
{
  constexpr float tiny = 1e-3F;
  constexpr float little_distance = 4e-3F;
  constexpr float little_change = 4e-3F;
  constexpr float little_stretch = 0.01F;
  constexpr float little_turn = 0.005F;
  constexpr float largest_curvature = 1.5F;
  constexpr float usually_fixed = 0.2F;     // the head, tail and seam of an animal
  constexpr float largest_fixed = 0.35F;    // with limbs in contact
  constexpr float usually_distorted = 0.2F; // limbs bent or in contact
  const float distorted_beyond = std::max(0.0F, evidence.score.distorted - usually_distorted);
  const float fixed_beyond = std::clamp(evidence.score.fixed, usually_fixed, largest_fixed) - usually_fixed;
  // Involution, turn and average_distance grow with the coarseness of the samples and with a pose: they normalise the
  // rest.
  return logistic(-10.3F - 3.2F * std::log(evidence.signs.stretch + little_stretch) -
                  1.5F * std::log(evidence.worst_distance + little_distance) -
                  3.0F * std::log(evidence.fit.distance + tiny) + 1.3F * std::log(evidence.fit.turn + little_turn) +
                  1.3F * std::log(evidence.signs.average_distance + little_change) +
                  1.5F * std::log(evidence.signs.involution + tiny) -
                  2.0F * std::min(evidence.rough_curvature, largest_curvature) - 25.6F * fixed_beyond -
                  10.0F * distorted_beyond + evidenceFromGaps(evidence));
}

float
weightOfHoles(float at_holes)
{
  constexpr float few = 0.02F;
  constexpr float many = 0.08F;
  return std::clamp((at_holes - few) / (many - few), 0.0F, 1.0F);
}

float
leastMapConfidence(float known_holes)
{
  constexpr float usual = 0.35F;
  constexpr float with_many_holes = 0.15F;
  return usual - (usual - with_many_holes) * weightOfHoles(known_holes);
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

std::vector<float>
pointConfidences(const SampledSurface& sampled, const SampleMap& map, float map_confidence)
{
  constexpr float tolerance = 0.05F;
  constexpr std::size_t maximum_probes = 200;
  const LandmarkSurface& landmarks = sampled.landmarks;
  const SampleInterpolation& interpolation = sampled.interpolation;
  const std::size_t probes = std::min(maximum_probes, landmarks.size());
  std::vector<float> change_at_landmark(landmarks.size(), 0.0F);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto image = static_cast<Eigen::Index>(landmarks.nearest_landmark[map[i]]);
    for (std::size_t j = 0; j < probes; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      change_at_landmark[i] +=
          std::abs(landmarks.distances(row, column) - landmarks.distances(image, landmarks.nearest_landmark[map[j]]));
    }
    change_at_landmark[i] /= static_cast<float>(probes) * landmarks.diameter * tolerance;
  }
  std::vector<float> change(sampled.coarse.size());
  for (std::size_t i = 0; i < sampled.coarse.size(); ++i) {
    change[i] = change_at_landmark[landmarks.nearest_landmark[i]];
  }
  std::vector<float> confidences(interpolation.offsets.size() - 1);
  for (std::size_t v = 0; v < confidences.size(); ++v) {
    const float at_point = interpolation.at(v, change);
    confidences[v] = std::clamp(map_confidence / (1.0F + at_point * at_point), 0.0F, 1.0F);
  }
  return confidences;
}

} // namespace symmetry
} // namespace pcl
