#include "symmetry/map_judgement.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

std::vector<Contender>
refineContenders(const SampleRefinement& refinement,
                 const std::vector<SymmetryCandidate>& candidates,
                 std::size_t maximum,
                 float margin)
{
  std::vector<Contender> contenders;
  for (const SymmetryCandidate& candidate : candidates) {
    if (contenders.size() >= maximum || candidate.score.value > candidates[0].score.value + margin) {
      break;
    }
    contenders.push_back({&candidate, refinement.refine(candidate)});
  }
  std::stable_sort(contenders.begin(), contenders.end(),
                   [](const Contender& a, const Contender& b) { return a.samples.value < b.samples.value; });
  return contenders;
}

MapJudge::MapJudge(const SampledSurface& sampled)
    : sampled_(sampled),
      spacing_(sampled.surface.is_cloud
                   ? measureSpacing(sampled.surface.graph, sampled.coarse.cells.vertices, sampled.landmarks.diameter)
                   : PointSpacing{}),
      share_at_holes_(static_cast<float>(std::count(sampled.coarse.at_hole.begin(), sampled.coarse.at_hole.end(), 1)) /
                      static_cast<float>(sampled.coarse.size()))
{
}

float
MapJudge::confidenceOf(const SymmetryCandidate& candidate, const SampleEstimate& samples) const
{
  return mapConfidence({samples.score, candidate.score.curvature,
                        findAsymmetry(sampled_.landmarks, sampled_.descriptor.curvature, samples.landmark_map),
                        samples.fit, samples.worst_distance, sampled_.surface.summary.smoothing_radius > 0.0F,
                        share_at_holes_, spacing_});
}

/** Share of the samples at holes where faces tell: sparse points have gaps that look alike. */
float
MapJudge::knownHoles() const
{
  return sampled_.surface.is_cloud && !sampled_.surface.summary.read_as_cloud ? 0.0F : share_at_holes_;
}

/** Brings the contender that is taken to the front and returns its confidence. */
float
MapJudge::chooseContender(std::vector<Contender>& contenders) const
{
  const float confidence = confidenceOf(*contenders.front().candidate, contenders.front().samples);
  const float least = leastMapConfidence(knownHoles());
  if (!sampled_.surface.is_cloud || confidence >= least) {
    return confidence;
  }
  std::vector<RatedMap> maps;
  maps.reserve(contenders.size());
  for (const Contender& contender : contenders) {
    maps.push_back({contender.samples.value, confidenceOf(*contender.candidate, contender.samples)});
  }
  const auto [number, trusted] = bestTrustedMap(maps, least);
  std::swap(contenders.front(), contenders[number]);
  return trusted;
}

MapEstimate
MapJudge::verdict(std::vector<Contender>& contenders) const
{
  MapEstimate estimate;
  estimate.status = SymmetryStatus::NoSymmetry;
  estimate.message = "no map explains the surface as a reflection of itself";
  estimate.diameter = sampled_.landmarks.diameter;
  if (contenders.empty()) {
    return estimate;
  }
  estimate.known_holes = knownHoles();
  const float confidence = chooseContender(contenders);
  const Contender& best = contenders.front();
  if (confidence < leastMapConfidence(estimate.known_holes)) {
    estimate.confidence = confidence_of_refused * confidence;
    if (isReflection(best.samples.score) || isReflection(best.candidate->score)) {
      estimate.message = "the best reflection of the surface fails in one place: one side has what the other lacks";
    }
    return estimate;
  }
  estimate.status = SymmetryStatus::Symmetric;
  estimate.message.clear();
  estimate.confidence = confidence;
  return estimate;
}

} // namespace symmetry
} // namespace pcl
