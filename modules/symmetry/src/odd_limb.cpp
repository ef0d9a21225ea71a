#include "symmetry/odd_limb.h"

#include "base/renumbering.h"
#include "base/statistics.h"
#include "symmetry/confidence/calibration.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/support.h"
#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/robust_method.h"
#include "symmetry/surface/limb.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace {

/** Whether something is left to be explained, and ends tell where limbs are: those of an object in parts do not. */
bool
isWorthALook(const Interpretation& best)
{
  const MapEstimate& estimate = best.estimate;
  const bool is_settled = estimate.status == SymmetryStatus::Symmetric && estimate.confidence >= in_doubt;
  return !is_settled && !estimate.is_by_plane && !estimate.partners.empty() && best.surface.part_of.empty();
}

/** Whether two limbs are one, found from two of its ends. */
bool
areOne(const Limb& a, const Limb& b)
{
  return a.holds(b.end) && b.holds(a.end);
}

/** Whether the map exchanges the ends of a limb and of another one of about the same size. */
bool
hasTwin(const Limb& limb, const std::vector<Limb>& limbs, const std::vector<Index>& partners)
{
  constexpr float alike = 1.25F; // by hand, never varied: poses change areas, and a stump is no twin
  const auto goes_to = [&partners](const Limb& from, const Limb& to) {
    return partners[from.end] != no_index && to.holds(partners[from.end]);
  };
  return !goes_to(limb, limb) && std::any_of(limbs.begin(), limbs.end(), [&](const Limb& other) {
    return goes_to(limb, other) && goes_to(other, limb) && other.share < alike * limb.share &&
           limb.share < alike * other.share;
  });
}

/** The limbs of a surface, those first that its map pairs with none; without the others where the map was found to be a
 * symmetry of the whole. */
std::vector<CandidateLimb>
limbsOf(const Interpretation& whole, std::size_t samples)
{
  std::vector<Limb> limbs;
  for (const Index end : whole.estimate.ends) {
    std::optional<Limb> limb = findLimb(whole.surface, end, samples);
    const bool is_large = limb && limb->share >= SupportSettings{}.least_area;
    if (is_large &&
        std::none_of(limbs.begin(), limbs.end(), [&limb](const Limb& other) { return areOne(*limb, other); })) {
      limbs.push_back(std::move(*limb));
    }
  }
  std::vector<CandidateLimb> candidates;
  std::transform(limbs.begin(), limbs.end(), std::back_inserter(candidates), [&](const Limb& limb) {
    return CandidateLimb{limb, hasTwin(limb, limbs, whole.estimate.partners)};
  });
  const auto with_twin =
      std::stable_partition(candidates.begin(), candidates.end(), [](const CandidateLimb& c) { return !c.has_twin; });
  if (whole.estimate.status == SymmetryStatus::Symmetric) {
    candidates.erase(with_twin, candidates.end());
  }
  return candidates;
}

/** Whether a map of what is left without a limb sends the place of its root elsewhere. That of a head or a tail stays
 * where it is. Of a circle that touches another one, half of the points are farther from that one's rim than
 * (sqrt 5 - 1) radii: so images farther away than one radius in the median are another place. */
bool
movesRoot(const Limb& limb, const PartOfSurface& rest, const std::vector<Index>& partners)
{
  constexpr float pi = 3.1415927F;
  const float radius = limb.girth / (2.0F * pi);
  std::vector<float> ways;
  for (std::size_t v = 0; v < rest.points.size(); ++v) {
    const float from_end = limb.distances[rest.points[v]];
    if (from_end <= limb.root + radius && partners[v] != no_index) {
      ways.push_back(limb.distances[rest.points[partners[v]]] - from_end);
    }
  }
  return !ways.empty() && median(std::move(ways)) > radius;
}

/** Misfits are logarithms: what is less by this fits twice as well. Chosen with the gains of right and wrong cuts in view
 * (doc/decisions/odd-limbs.md). */
constexpr float twice = 0.6931472F;

/** Whether the map without a limb is to be preferred to the one so far: it fits twice as well, or it is more likely right
 * than not and better: where that one leaves something out, too, it fits better; else its confidence is strong evidence,
 * as for all parts without a counterpart. A map that was refused counts as one that was just refused. */
bool
isPreferred(const MapEstimate& without_limb, const MapEstimate& so_far)
{
  constexpr RefusalCalibration refusal;
  const float gain = so_far.misfit - without_limb.misfit;
  const float trust = without_limb.confidence * (1.0F - without_limb.unsupported_share);
  if (gain >= twice) {
    return trust >= refusal.several_interpretations;
  }
  const bool is_better =
      so_far.status == SymmetryStatus::PartlySymmetric
          ? gain > 0.0F
          : isStrongEvidence(without_limb.confidence, std::max(so_far.confidence, refusal.several_interpretations));
  return is_better && trust >= refusal.partial;
}

/** Gives what is known of a part of a surface the numbers of the whole; the rest of it has no counterpart. */
void
carryOver(MapEstimate& estimate, const std::vector<Index>& points, std::size_t size)
{
  const auto to_whole = [&points](Index v) {
    return v == no_index ? no_index : points[v];
  };
  const auto renumber_all = [&](std::vector<Index>& numbers) {
    std::transform(numbers.begin(), numbers.end(), numbers.begin(), to_whole);
  };
  const auto scatter_map = [&](std::vector<Index>& map) {
    renumber_all(map);
    scatter(map, points, size, no_index);
  };
  scatter_map(estimate.partners);
  for (std::vector<AlternativeMap>* maps : {&estimate.alternatives, &estimate.rotations}) {
    for (AlternativeMap& map : *maps) {
      scatter_map(map.partners);
    }
  }
  scatter(estimate.confidences, points, size, 0.0F);
  scatter(estimate.side_function, points, size, 0.0F);
  scatter(estimate.regions, points, size, Region::None);
  scatter(estimate.support, points, size, 0.0F);
  if (!estimate.landmark_of.empty()) {
    scatter(estimate.landmark_of, points, size, no_index);
  }
  estimate.is_unsupported.assign(points.size(), 0);
  scatter(estimate.is_unsupported, points, size, char{1});
  renumber_all(estimate.extremities);
  renumber_all(estimate.ends);
  for (SymmetricMatch& match : estimate.matches) {
    match = {to_whole(match.source), to_whole(match.target), to_whole(match.midpoint), match.cost};
  }
}

} // namespace

std::optional<MapEstimate>
mapWithoutLimb(const CandidateLimb& candidate,
               const Interpretation& whole,
               const SymmetryParameters& parameters,
               StepTimer& timer)
{
  const Limb& limb = candidate.limb;
  const PartOfSurface rest = withoutLimb(whole.surface, limb);
  const std::vector<Index> known = mapOnSurface(rest.surface, whole);
  RobustSettings settings = robustSettings(parameters);
  settings.score_to_beat = whole.estimate.search_score;
  MapEstimate estimate = estimateRobust(rest.surface, parameters, settings, timer, {known});
  if (estimate.status != SymmetryStatus::Symmetric || estimate.is_partial ||
      !movesRoot(limb, rest, estimate.partners)) {
    return std::nullopt;
  }
  // By the map of the whole it has a counterpart: that map must be another one, and much worse.
  if (candidate.has_twin && (whole.estimate.misfit - estimate.misfit < twice ||
                             areAlike(imagesOf(rest.surface, estimate.partners), imagesOf(rest.surface, known)))) {
    return std::nullopt;
  }
  carryOver(estimate, rest.points, whole.surface.size());
  estimate.unsupported_share = 1.0F - shareWithPartner(whole.surface, estimate.partners);
  estimate.is_partial = true;
  estimate.status = SymmetryStatus::PartlySymmetric;
  estimate.message = "a part of the surface has no counterpart";
  return estimate;
}

void
giveBack(CandidateLimb candidate,
         const Interpretation& whole,
         const SymmetryParameters& parameters,
         StepTimer& timer,
         MapEstimate& found)
{
  constexpr float step = 0.9F; // by hand
  for (bool is_better = true; is_better;) {
    candidate.limb.root *= step;
    std::optional<MapEstimate> estimate = mapWithoutLimb(candidate, whole, parameters, timer);
    is_better = estimate && estimate->misfit < found.misfit && isPreferred(*estimate, whole.estimate);
    if (is_better) {
      found = std::move(*estimate);
    }
  }
}

std::optional<Interpretation>
mapWithoutOddLimb(const Interpretation& best, const SymmetryParameters& parameters, StepTimer& timer)
{
  if (!isWorthALook(best)) {
    return std::nullopt;
  }
  std::optional<MapEstimate> found; // the one that fits best
  CandidateLimb odd;
  for (const CandidateLimb& candidate : limbsOf(best, robustSettings(parameters).sampling.samples)) {
    std::optional<MapEstimate> without = mapWithoutLimb(candidate, best, parameters, timer);
    if (without && (!found || without->misfit < found->misfit)) {
      found = std::move(without);
      odd = candidate;
    }
    if (found && found->confidence >= beyond_doubt && isPreferred(*found, best.estimate)) {
      break;
    }
  }
  if (!found || !isPreferred(*found, best.estimate)) {
    return std::nullopt;
  }
  giveBack(odd, best, parameters, timer, *found);
  return Interpretation{best.surface, std::move(*found)};
}

} // namespace symmetry
} // namespace pcl
