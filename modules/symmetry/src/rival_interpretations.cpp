#include "symmetry/rival_interpretations.h"

#include "symmetry/confidence/calibration.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/point_confidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

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

/** The map is none, whatever it was before others were heard.
 * \param[in] refusal what is said of a map that was a symmetry then */
void
refuse(Interpretation& interpretation, float confidence, const char* refusal)
{
  MapEstimate& estimate = interpretation.estimate;
  if (estimate.status == SymmetryStatus::Symmetric) {
    estimate.message = refusal;
  }
  estimate.status = SymmetryStatus::NoSymmetry;
  estimate.confidence = confidence_of_refused * confidence;
}

/** Whether the map is found, as a whole or of a part, however it was refused.
 * \param[in] refusal see refuse () */
void
giveVerdict(Interpretation& interpretation, float confidence, const char* refusal)
{
  if (confidence < leastOfSeveralInterpretations(interpretation)) {
    refuse(interpretation, confidence, refusal);
    return;
  }
  MapEstimate& estimate = interpretation.estimate;
  estimate.status = estimate.is_partial ? SymmetryStatus::PartlySymmetric : SymmetryStatus::Symmetric;
  estimate.message = estimate.is_partial ? "a part of the surface has no counterpart" : "";
  takeConfidence(estimate, confidence);
}

/** Keeps the map that can be trusted more on what a closer look leaves. */
bool
takeIfMoreTrusted(std::optional<Interpretation>& kept, const Interpretation& interpretation)
{
  const bool is_better = !kept || interpretation.estimate.trust_of_part > kept->estimate.trust_of_part;
  if (is_better) {
    kept = interpretation;
  }
  return is_better;
}

/** Whether most of what has a mark in either has one in both. */
bool
areMostlyShared(const std::vector<char>& a, const std::vector<char>& b)
{
  std::size_t in_both = 0;
  std::size_t in_either = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    in_both += a[i] != 0 && b[i] != 0 ? 1U : 0U;
    in_either += a[i] != 0 || b[i] != 0 ? 1U : 0U;
  }
  return 2 * in_both > in_either;
}

} // namespace

void
RivalInterpretations::add(Interpretation interpretation)
{
  ++interpretations_;
  addCloserLook(interpretation);
  const MapEstimate& estimate = interpretation.estimate;
  const bool by_odds = pooling_ == Pooling::Odds;
  const bool has_vote = by_odds || estimate.is_partial || estimate.status == SymmetryStatus::Symmetric;
  const float trust = has_vote ? estimate.trust : 0.0F;
  const bool in_part = !by_odds && estimate.is_partial;
  std::vector<Vector3> images = imagesOfProbes(interpretation, in_part ? MapPart::Supported : MapPart::Whole);
  auto same = std::find_if(rivals_.begin(), rivals_.end(), [&](const Rival& rival) {
    const std::vector<Vector3>& others = rival.kind().images;
    return images.empty() == others.empty() && areAlike(images, others);
  });
  if (same == rivals_.end()) {
    same = rivals_.insert(rivals_.end(), Rival{});
  }
  ++same->interpretations;
  Kind& kind = estimate.is_partial ? same->part : same->whole;
  const auto is_better = [&](const MapEstimate& kept) {
    return by_odds || estimate.misfit == kept.misfit ? estimate.trust > kept.trust : estimate.misfit < kept.misfit;
  };
  const bool is_kept = !kind.kept || is_better(kind.kept->estimate);
  kind.evidence = by_odds ? std::max(kind.evidence, trust) : kind.evidence + trust;
  kind.fitting_evidence = by_odds ? kind.evidence : kind.fitting_evidence + trust * std::exp(-estimate.misfit);
  kind.trust = std::max(kind.trust, trust);
  if (is_kept) {
    kind.kept = std::move(interpretation);
    kind.images = std::move(images);
  }
}

bool
RivalInterpretations::isSettled() const
{
  if (rivals_.empty()) {
    return false;
  }
  const MapEstimate& estimate = best().estimate;
  if (estimate.status == SymmetryStatus::TooFewPoints) {
    return true;
  }
  if (estimate.is_partial && !estimate.is_by_plane) {
    return false; // one of those to come may explain the whole
  }
  return pooling_ == Pooling::Odds ? isSettledByOdds() : isSettledByVotes();
}

const Interpretation&
RivalInterpretations::best() const
{
  return *rivals_[bestRival()].kind().kept;
}

std::vector<std::vector<Index>>
RivalInterpretations::mapsOn(const PreparedSurface& surface) const
{
  constexpr std::size_t most = 3; // each costs the refinement of a contender
  std::vector<const Rival*> order;
  for (const Rival& rival : rivals_) {
    if (!rival.kind().kept->estimate.partners.empty()) {
      order.push_back(&rival);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [this](const Rival* a, const Rival* b) { return evidenceOf(*a) > evidenceOf(*b); });
  order.resize(std::min(order.size(), most));
  std::vector<std::vector<Index>> maps(order.size());
  std::transform(order.begin(), order.end(), maps.begin(),
                 [&surface](const Rival* rival) { return mapOnSurface(surface, *rival->kind().kept); });
  return maps;
}

Interpretation
RivalInterpretations::takeBest()
{
  const std::size_t number = bestRival();
  Rival& best = rivals_[number];
  const float share = shareOfOdds(number);
  const float agreement = evidenceOf(best) / static_cast<float>(interpretations_);
  const bool is_found_by_most = 2 * best.interpretations > interpretations_;
  Kind& kind = &best.kind() == &best.whole ? best.whole : best.part;
  Interpretation interpretation = std::move(*kind.kept);
  const MapEstimate& estimate = interpretation.estimate;
  if (estimate.status == SymmetryStatus::TooFewPoints) {
    return interpretation;
  }
  if (pooling_ == Pooling::Odds) {
    static constexpr const char* contradiction = "ways to understand the surface contradict each other";
    if (share < in_doubt && !is_found_by_most) {
      refuse(interpretation, share, contradiction);
    }
    else {
      giveVerdict(interpretation, share, contradiction);
    }
  }
  else if (interpretations_ > 1 || estimate.is_partial) {
    giveVerdict(interpretation, std::sqrt(agreement * kind.trust),
                "hardly any way to read the points shows a symmetry");
  }
  if (interpretation.estimate.status == SymmetryStatus::NoSymmetry && part_) {
    interpretation = std::move(*part_);
    interpretation.estimate.is_partial = true;
    giveVerdict(interpretation, interpretation.estimate.trust_of_part, "");
  }
  return interpretation;
}

/** One closer look among several maps that are all refused finds something by chance. What the surface lacks on one side is
 * found with other samples as well. */
void
RivalInterpretations::addCloserLook(const Interpretation& interpretation)
{
  if (interpretation.estimate.trust_of_part <= 0.0F) {
    return;
  }
  const std::vector<char> left_out = unsupportedInInput(interpretation);
  const auto is_same = [&left_out](const std::vector<char>& other) {
    return areMostlyShared(left_out, other);
  };
  if (std::any_of(left_out_.begin(), left_out_.end(), is_same)) {
    takeIfMoreTrusted(part_, interpretation);
  }
  if (looked_at_ && is_same(left_out_[look_at_it_])) {
    takeIfMoreTrusted(part_, *looked_at_);
  }
  if (takeIfMoreTrusted(looked_at_, interpretation)) {
    look_at_it_ = left_out_.size();
  }
  left_out_.push_back(left_out);
}

bool
RivalInterpretations::isSettledByOdds() const
{
  constexpr std::size_t enough = 3; // to agree
  constexpr float more_likely_than_not = 0.5F;
  const bool are_unanimous = interpretations_ >= enough && rivals_.size() == 1;
  return shareOfOdds(bestRival()) >= (are_unanimous ? more_likely_than_not : in_doubt);
}

bool
RivalInterpretations::isSettledByVotes() const
{
  constexpr float sure_together =
      2.0F;                       // by hand, as the next: three interpretations that agree, each sure enough alone
  constexpr float usually = 0.6F; // of all interpretations so far
  const std::size_t best = bestRival();
  float contradicting = 0.0F;
  for (std::size_t i = 0; i < rivals_.size(); ++i) {
    contradicting += i == best ? 0.0F : evidenceOf(rivals_[i]);
  }
  const float evidence = evidenceOf(rivals_[best]);
  const bool is_usual = evidence >= sure_together && evidence >= usually * static_cast<float>(interpretations_);
  return is_usual || (rivals_[best].kind().trust >= beyond_doubt && evidence > contradicting);
}

/** How much speaks for the map of a rival. */
float
RivalInterpretations::evidenceOf(const Rival& rival) const
{
  return pooling_ == Pooling::Odds ? rival.kind().evidence : rival.whole.evidence + rival.part.evidence;
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
    all += odds(evidenceOf(other));
  }
  return odds(evidenceOf(rivals_[rival])) / all;
}

std::size_t
RivalInterpretations::bestRival() const
{
  const auto comes_before = [this](const Rival& a, const Rival& b) {
    const float of_a = evidenceOf(a);
    const float of_b = evidenceOf(b);
    return of_a != of_b ? of_a > of_b : a.kind().trust > b.kind().trust;
  };
  return static_cast<std::size_t>(std::min_element(rivals_.begin(), rivals_.end(), comes_before) - rivals_.begin());
}

} // namespace symmetry
} // namespace pcl
