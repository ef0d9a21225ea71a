#include "symmetry/map_judgement.h"

#include "base/parallel.h"
#include "symmetry/confidence/calibration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Whether one of the landmarks with a mark is the end of a limb. */
bool
holdsEnd(const LandmarkSurface& landmarks, const std::vector<char>& marks)
{
  const std::vector<Index> ends = extremitiesOf(landmarks, limb_separation, most_limbs);
  return std::any_of(ends.begin(), ends.end(), [&marks](Index end) { return marks[end] != 0; });
}

} // namespace

std::vector<const SymmetryCandidate*>
closestCandidates(const SampleRefinement& refinement,
                  const std::vector<SymmetryCandidate>& candidates,
                  std::size_t maximum,
                  float margin)
{
  std::vector<std::pair<float, const SymmetryCandidate*>> order;
  order.reserve(candidates.size());
  for (const SymmetryCandidate& candidate : candidates) {
    order.emplace_back(refinement.promise(candidate), &candidate);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const SymmetryCandidate*> closest;
  for (const auto& [promise, candidate] : order) {
    if (closest.size() >= maximum || promise > order.front().first + margin) {
      break;
    }
    closest.push_back(candidate);
  }
  return closest;
}

void
addContenders(const SampleRefinement& refinement,
              const std::vector<const SymmetryCandidate*>& candidates,
              std::vector<Contender>& contenders)
{
  const std::size_t first = contenders.size();
  for (const SymmetryCandidate* candidate : candidates) {
    contenders.push_back({candidate, {}});
  }
  const auto refine = [&](std::size_t k) {
    contenders[k].samples = refinement.refine(*contenders[k].candidate);
  };
  if (candidates.size() == 1) {
    refine(first); // whose loops are shared out among the threads
  }
  else { // threads are busier with one candidate each
    parallelFor(candidates.size(), [&refine, first](std::size_t k) { refine(first + k); });
  }
  std::stable_sort(contenders.begin(), contenders.end(),
                   [](const Contender& a, const Contender& b) { return a.samples.value < b.samples.value; });
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

/** Whether what is left is more to be trusted than the whole: a part is left out where that is strong evidence for the
 * map, and where the rest is more likely right than not. */
bool
MapJudge::JudgedSupport::outweighs(float of_whole) const
{
  constexpr float largest_share = 0.5F; // where more is left out, the rest is not what the surface is
  return support.unsupported_share > 0.0F && support.unsupported_share < largest_share &&
         trust() >= RefusalCalibration{}.partial && isStrongEvidence(confidence, of_whole);
}

MapJudge::JudgedSupport
MapJudge::judgeRest(const Contender& contender,
                    const MapEvidence& evidence,
                    float confidence,
                    const SupportSettings& settings) const
{
  JudgedSupport rest{{}, evidence.local_changes, confidence};
  rest.support = findSupport(sampled_, contender.samples, rest.changes, settings);
  if (rest.support.unsupported_share > 0.0F) {
    // What was disturbed by an odd part does not count as evidence, but has a counterpart.
    rest.support = takeBackSupported(sampled_, contender.samples, rest.support, settings, rest.changes);
    rest.confidence = mapConfidence(
        gatherSupportedEvidence(sampled_, *contender.candidate, contender.samples, rest.support, evidence));
  }
  return rest;
}

/** Where a map is refused as a whole and nothing changes by much, what makes it look wrong lies where less changes: looks
 * there in two steps, down to half of what is looked for otherwise (by hand; see doc/decisions/support.md). There a patch or a band around the trunk may be what
 * the map tears itself; what has no counterpart sticks out. */
std::optional<MapJudge::JudgedSupport>
MapJudge::lookCloser(const Contender& contender, const MapEvidence& evidence, float confidence) const
{
  constexpr int looks = 2;
  SupportSettings settings;
  settings.suspects_images = true;
  for (int look = 0; look < looks; ++look) {
    settings.change *= std::sqrt(0.5F);
    JudgedSupport rest = judgeRest(contender, evidence, confidence, settings);
    if (rest.outweighs(confidence) && holdsEnd(sampled_.landmarks, rest.support.is_unsupported)) {
      return rest;
    }
  }
  return std::nullopt;
}

/** Which parts have no counterpart, and how far the map of the rest can be trusted. */
void
MapJudge::judgeSupport(const Contender& contender,
                       const MapEvidence& evidence,
                       float confidence,
                       MapEstimate& estimate) const
{
  const SupportSettings settings;
  JudgedSupport rest = judgeRest(contender, evidence, confidence, settings);
  estimate.is_partial = rest.outweighs(confidence);
  estimate.trust = estimate.is_partial ? rest.trust() : confidence;
  if (!estimate.is_partial && confidence < RefusalCalibration{}.one_interpretation) {
    if (std::optional<JudgedSupport> closer = lookCloser(contender, evidence, confidence)) {
      rest = std::move(*closer);
      estimate.trust_of_part = rest.trust();
    }
  }
  const Support& support = rest.support;
  const std::vector<float>& changes = rest.changes;
  estimate.supported_confidence = rest.confidence;
  estimate.unsupported_share = support.unsupported_share;
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
  for (const Index end : extremitiesOf(sampled_.landmarks, limb_separation, most_limbs)) {
    estimate.ends.push_back(sampled_.coarse.cells.vertices[end]);
  }
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
