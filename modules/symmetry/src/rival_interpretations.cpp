#include "symmetry/rival_interpretations.h"

#include "base/vector_math.h"
#include "symmetry/confidence/calibration.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/point_confidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Where some evenly numbered points of the input go; not a number where they go nowhere. Empty without a dense map. */
std::vector<Vector3>
imagesOfProbes(const Interpretation& interpretation)
{
  constexpr std::size_t probes = 500;
  constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Index>& representatives = interpretation.surface.representatives;
  const std::vector<Index>& partners = interpretation.estimate.partners;
  std::vector<Vector3> images;
  const std::size_t step = std::max<std::size_t>(1, representatives.size() / probes);
  for (std::size_t v = 0; !partners.empty() && v < representatives.size(); v += step) {
    const Index partner = representatives[v] == no_index ? no_index : partners[representatives[v]];
    images.push_back(partner == no_index ? Vector3{nowhere, nowhere, nowhere} : interpretation.surface.points[partner]);
  }
  return images;
}

/** Whether most points go to the same places; so they do where there are none. */
bool
areAlike(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  constexpr float near = 0.1F; // surfaces are at unit scale
  constexpr double most = 0.7; // by hand
  std::size_t both = 0;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const float apart = distance(a[i], b[i]);
    both += apart >= 0.0F ? 1U : 0U; // false for what is not a number
    alike += apart < near ? 1U : 0U;
  }
  return static_cast<double>(alike) >= most * static_cast<double>(both);
}

/** Whether noise or points at random places make each interpretation of a cloud uncertain. */
bool
isUncertain(const PreparedSurface& surface)
{
  constexpr std::size_t probes = 2000;
  if (surface.summary.smoothing_radius > 0.0F) {
    return true;
  }
  if (!surface.is_cloud || surface.summary.read_as_cloud) {
    return false; // faces tell what is between the points, and the graph of a mesh has edges across faces
  }
  std::vector<Index> probed;
  const std::size_t step = std::max<std::size_t>(1, surface.size() / probes);
  for (std::size_t v = 0; v < surface.graph.size(); v += step) {
    probed.push_back(static_cast<Index>(v));
  }
  return measureSpacing(surface.graph, probed, 1.0F).irregularity >= random_irregularity;
}

/** Below this confidence after several interpretations there is no symmetry. */
float
leastOfSeveralInterpretations(const Interpretation& interpretation)
{
  constexpr RefusalCalibration refusal;
  return isUncertain(interpretation.surface) ? refusal.uncertain : refusal.several_interpretations;
}

/** Gives the map another confidence, and with it the points and the other symmetries, of which it is the first. */
void
takeConfidence(MapEstimate& estimate, float confidence)
{
  for (float& of_point : estimate.confidences) {
    of_point = withMapConfidence(of_point, estimate.confidence, confidence);
  }
  const float share = estimate.map_confidence > 0.0F ? confidence / estimate.map_confidence : 0.0F;
  for (std::vector<AlternativeMap>* maps : {&estimate.alternatives, &estimate.rotations}) {
    for (AlternativeMap& map : *maps) {
      map.confidence = std::min(1.0F, map.confidence * share);
    }
  }
  if (!estimate.alternatives.empty()) {
    estimate.alternatives.front().confidence = confidence;
  }
  estimate.confidence = confidence;
}

} // namespace

void
RivalInterpretations::add(Interpretation interpretation)
{
  ++interpretations_;
  const MapEstimate& estimate = interpretation.estimate;
  const bool by_odds = pooling_ == Pooling::Odds;
  const bool is_found = by_odds ? !estimate.partners.empty() : estimate.status == SymmetryStatus::Symmetric;
  const float confidence = by_odds ? estimate.trust : estimate.confidence;
  if (!by_odds && estimate.is_partial && (!partial_ || estimate.trust > partial_->estimate.trust)) {
    partial_ = interpretation;
  }
  std::vector<Vector3> images = is_found ? imagesOfProbes(interpretation) : std::vector<Vector3>{};
  const auto same = std::find_if(rivals_.begin(), rivals_.end(), [&](const Rival& rival) {
    return is_found == rival.is_found && areAlike(images, rival.images);
  });
  if (same == rivals_.end()) {
    rivals_.push_back(
        {std::move(interpretation), std::move(images), is_found, confidence, is_found ? confidence : 0.0F});
    return;
  }
  same->evidence = !is_found ? 0.0F : by_odds ? std::max(same->evidence, confidence) : same->evidence + confidence;
  if (confidence > same->confidence) {
    same->interpretation = std::move(interpretation);
    same->images = std::move(images);
    same->confidence = confidence;
  }
}

bool
RivalInterpretations::isSettled() const
{
  if (rivals_.empty()) {
    return false;
  }
  const std::size_t best = bestRival();
  const MapEstimate& estimate = rivals_[best].interpretation.estimate;
  if (estimate.status == SymmetryStatus::TooFewPoints) {
    return true;
  }
  if (pooling_ == Pooling::Odds) {
    return !estimate.is_partial && shareOfOdds(best) >= in_doubt;
  }
  constexpr float beyond_doubt = 0.9F;  // this and the next two by hand
  constexpr float sure_together = 2.0F; // three interpretations that agree, each sure enough alone
  constexpr float usually = 0.6F;       // of all interpretations so far
  float contradicting = 0.0F;
  for (std::size_t i = 0; i < rivals_.size(); ++i) {
    contradicting += i == best ? 0.0F : rivals_[i].evidence;
  }
  const float evidence = rivals_[best].evidence;
  const bool is_usual = evidence >= sure_together && evidence >= usually * static_cast<float>(interpretations_);
  return is_usual || (estimate.confidence >= beyond_doubt && evidence > contradicting);
}

const Interpretation&
RivalInterpretations::best() const
{
  return rivals_[bestRival()].interpretation;
}

Interpretation
RivalInterpretations::takeBest()
{
  const std::size_t best = bestRival();
  Interpretation interpretation = std::move(rivals_[best].interpretation);
  MapEstimate& estimate = interpretation.estimate;
  if (estimate.status == SymmetryStatus::TooFewPoints) {
    return interpretation;
  }
  if (pooling_ == Pooling::Odds) {
    takeOdds(interpretation, shareOfOdds(best));
    return interpretation;
  }
  if (estimate.status == SymmetryStatus::Symmetric && interpretations_ > 1) {
    takeVotes(interpretation, rivals_[best].evidence);
  }
  if (partial_ && partial_->estimate.trust > estimate.confidence) {
    // What none explains as a whole, or hardly any, one may explain in part.
    takeOdds(*partial_, partial_->estimate.trust);
    return std::move(*partial_);
  }
  return interpretation;
}

/** The odds of a rival's map over those of all maps and of none. */
float
RivalInterpretations::shareOfOdds(std::size_t rival) const
{
  static constexpr float surest = 0.9999F; // keeps odds finite
  const auto odds = [](float confidence) {
    const float bounded = confidence < surest ? confidence : surest;
    return bounded / (1.0F - bounded);
  };
  float all = 1.0F; // of none
  for (const Rival& other : rivals_) {
    all += odds(other.evidence);
  }
  return odds(rivals_[rival].evidence) / all;
}

void
RivalInterpretations::takeOdds(Interpretation& interpretation, float confidence)
{
  MapEstimate& estimate = interpretation.estimate;
  if (confidence >= leastOfSeveralInterpretations(interpretation)) {
    estimate.status = estimate.is_partial ? SymmetryStatus::PartlySymmetric : SymmetryStatus::Symmetric;
    estimate.message = estimate.is_partial ? "a part of the surface has no counterpart" : "";
    takeConfidence(estimate, confidence);
    return;
  }
  if (estimate.status == SymmetryStatus::Symmetric) {
    estimate.message = "ways to understand the surface contradict each other";
  }
  estimate.status = SymmetryStatus::NoSymmetry;
  estimate.confidence = confidence_of_refused * confidence;
}

void
RivalInterpretations::takeVotes(Interpretation& interpretation, float evidence) const
{
  MapEstimate& estimate = interpretation.estimate;
  const float agreement = evidence / static_cast<float>(interpretations_);
  takeConfidence(estimate, std::sqrt(agreement * estimate.confidence));
  if (estimate.confidence < leastOfSeveralInterpretations(interpretation)) {
    estimate.status = SymmetryStatus::NoSymmetry;
    estimate.message = "hardly any way to read the points shows a symmetry";
  }
}

std::size_t
RivalInterpretations::bestRival() const
{
  const auto comes_before = [](const Rival& a, const Rival& b) {
    return a.evidence != b.evidence ? a.evidence > b.evidence : a.confidence > b.confidence;
  };
  return static_cast<std::size_t>(std::min_element(rivals_.begin(), rivals_.end(), comes_before) - rivals_.begin());
}

} // namespace symmetry
} // namespace pcl
