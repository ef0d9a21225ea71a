#include "symmetry/map_judgement.h"

#include "symmetry/confidence/calibration.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

void
sortByValue(std::vector<Contender>& contenders)
{
  std::stable_sort(contenders.begin(), contenders.end(),
                   [](const Contender& a, const Contender& b) { return a.samples.value < b.samples.value; });
}

} // namespace

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
  sortByValue(contenders);
  return contenders;
}

void
addContenders(const SampleRefinement& refinement,
              const std::vector<SymmetryCandidate>& candidates,
              std::vector<Contender>& contenders)
{
  for (const SymmetryCandidate& candidate : candidates) {
    contenders.push_back({&candidate, refinement.refine(candidate)});
  }
  sortByValue(contenders);
}

MapJudge::MapJudge(const SampledSurface& sampled)
    : sampled_(sampled),
      // The faces of a mesh tell what is between its points, also where it is read as a cloud.
      spacing_(sampled.surface.is_cloud && !sampled.surface.summary.read_as_cloud
                   ? measureSpacing(sampled.surface.graph, sampled.coarse.cells.vertices, sampled.landmarks.diameter)
                   : PointSpacing{})
{
}

/** Share of the samples at holes where faces tell: sparse points have gaps that look alike. */
float
MapJudge::knownHoles() const
{
  return sampled_.surface.is_cloud && !sampled_.surface.summary.read_as_cloud ? 0.0F : shareAtHoles(sampled_.coarse);
}

/** Brings the contender that is taken to the front and returns its confidence. */
float
MapJudge::chooseContender(std::vector<Contender>& contenders, MapEvidence& evidence) const
{
  evidence = evidenceFor(*contenders.front().candidate, contenders.front().samples);
  const float confidence = mapConfidence(evidence);
  const float least = RefusalCalibration{}.one_interpretation;
  if (!sampled_.surface.is_cloud || confidence >= least) {
    return confidence;
  }
  std::vector<MapEvidence> evidences{evidence};
  std::vector<RatedMap> maps{{contenders.front().samples.value, confidence}};
  for (std::size_t k = 1; k < contenders.size(); ++k) {
    evidences.push_back(evidenceFor(*contenders[k].candidate, contenders[k].samples));
    maps.push_back({contenders[k].samples.value, mapConfidence(evidences.back())});
  }
  const auto [number, trusted] = bestTrustedMap(maps, least);
  std::swap(contenders.front(), contenders[number]);
  evidence = evidences[number];
  return trusted;
}

/** Which parts have no counterpart, and how far the map of the rest can be trusted.
 *
 * They are left out where that raises the odds of the map tenfold: strong evidence (H. Jeffreys, Theory of
 * probability, 1961); and where the rest is more likely right than not. */
void
MapJudge::judgeSupport(const Contender& contender,
                       const MapEvidence& evidence,
                       float confidence,
                       MapEstimate& estimate) const
{
  constexpr float strong = 10.0F;
  constexpr float largest_share = 0.5F; // where more is left out, the rest is not what the surface is
  const SupportSettings settings;
  std::vector<float> changes = evidence.local_changes;
  Support support = findSupport(sampled_, contender.samples, changes, settings);
  estimate.supported_confidence = confidence;
  if (support.unsupported_share > 0.0F) {
    // What was disturbed by an odd part does not count as evidence, but has a counterpart.
    support = takeBackSupported(sampled_, contender.samples, support, settings, changes);
    estimate.supported_confidence =
        mapConfidence(gatherSupportedEvidence(sampled_, *contender.candidate, contender.samples, support, evidence));
  }
  estimate.unsupported_share = support.unsupported_share;
  const auto odds = [](float p) {
    return p / std::max(1e-6F, 1.0F - p);
  };
  const float of_rest = estimate.supported_confidence * (1.0F - support.unsupported_share);
  estimate.is_partial = support.unsupported_share > 0.0F && support.unsupported_share < largest_share &&
                        of_rest >= RefusalCalibration{}.partial &&
                        odds(estimate.supported_confidence) >= strong * odds(confidence);
  estimate.trust = estimate.is_partial ? of_rest : confidence;
  estimate.measures.emplace_back("unsupported_share", estimate.unsupported_share);
  estimate.measures.emplace_back("supported_confidence", estimate.supported_confidence);
  estimate.landmark_evidence = pointEvidence(sampled_, contender.samples, changes);
  std::vector<float> at_samples(sampled_.coarse.size());
  for (std::size_t i = 0; i < at_samples.size(); ++i) {
    const float change = changes[sampled_.landmarks.nearest_landmark[i]] / settings.change;
    at_samples[i] = 1.0F / (1.0F + change * change);
  }
  for (std::size_t v = 0; v < sampled_.surface.size(); ++v) {
    const Index landmark = sampled_.landmarks.nearest_landmark[sampled_.coarse.cells.owner[v]];
    estimate.landmark_of.push_back(landmark);
    estimate.is_unsupported.push_back(support.is_unsupported[landmark]);
    estimate.support.push_back(std::clamp(sampled_.interpolation.at(v, at_samples), 0.0F, 1.0F));
  }
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
  MapEvidence evidence;
  const float confidence = chooseContender(contenders, evidence);
  estimate.measures = namedMeasures(evidence);
  judgeSupport(contenders.front(), evidence, confidence, estimate);
  estimate.map_confidence = confidence;
  estimate.misfit = contenders.front().samples.value;
  estimate.measures.emplace_back("misfit", estimate.misfit);
  const Contender& best = contenders.front();
  if (confidence < RefusalCalibration{}.one_interpretation) {
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
