#include "symmetry/robust_method.h"

#include "symmetry/map_delivery.h"
#include "symmetry/map_judgement.h"
#include "symmetry/search/given_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t minimum_points = 60;

MapEstimate
tooFewPoints()
{
  MapEstimate estimate;
  estimate.status = SymmetryStatus::TooFewPoints;
  estimate.message = "the robust method needs " + std::to_string(minimum_points) + " connected points, " +
                     std::to_string(minimum_samples) + " of them at distinct places";
  return estimate;
}

/** Whether a mirror plane is more to be trusted than the best map that the search has found.
 *
 * Most of a surface hardly lies exactly on itself by chance: where a map sends it elsewhere the plane is right, however
 * certain the map is. But a plier is its own mirror image through its thickness, and a doll front to back, while what
 * people mean is that its limbs change places: a plane that moves the surface much less than a sure map does not count.
 *
 * Where a map does the same the plane is more precise. What it leaves out may be a pose, which the map explains: refused or
 * not, limbs that go to each other, across the plane; where the map of the whole is as certain as the plane also a head or a
 * tail, which goes to itself, across the plane that it is rooted in (PlaneComparison::is_pose). An odd part is sent into
 * itself, or anywhere, and is rooted on one side. */
bool
explainsMore(const MirrorFit& plane,
             const SampledSurface& sampled,
             const std::vector<Contender>& contenders,
             const MapEstimate& estimate,
             const MirrorSettings& settings)
{
  if (contenders.empty()) {
    return true;
  }
  const PlaneComparison map = compareWithPlane(sampled, contenders.front().samples, plane, settings);
  if (!plane.is_of_part) {
    const bool is_in_doubt = estimate.confidence < std::min(plane.share, in_doubt);
    return is_in_doubt || (map.contradicts ? !map.moves_farther : !map.is_pose || carriesAll(plane, sampled, settings));
  }
  const bool explains_rest =
      !map.contradicts && (map.exchanges || (map.is_pose && map.keeps_rest && estimate.confidence >= plane.share));
  const bool is_certain = sampled.surface.part_of.empty() && estimate.trust >= plane.share &&
                          (map.contradicts ? map.moves_farther : map.is_pose);
  return !explains_rest && !is_certain;
}

std::vector<const SymmetryCandidate*>
allOf(const std::vector<SymmetryCandidate>& candidates)
{
  std::vector<const SymmetryCandidate*> all(candidates.size());
  std::transform(candidates.begin(), candidates.end(), all.begin(), [](const SymmetryCandidate& c) { return &c; });
  return all;
}

/** What the map may be, among the landmarks. */
struct Hypotheses {
  std::vector<SymmetryCandidate> searched; ///< the best one first
  std::vector<SymmetryCandidate> given;    ///< near maps that are known from elsewhere

  /** The best score; infinite where there is no candidate. */
  float
  bestScore() const
  {
    float best = std::numeric_limits<float>::infinity();
    for (const std::vector<SymmetryCandidate>* candidates : {&searched, &given}) {
      for (const SymmetryCandidate& candidate : *candidates) {
        best = std::min(best, candidate.score.value);
      }
    }
    return best;
  }

  /** Those that are worth refining: the best ones of the search, and all that are given. */
  std::vector<const SymmetryCandidate*>
  promising(const SampleRefinement& refinement, const RobustSettings& settings) const
  {
    std::vector<const SymmetryCandidate*> all =
        closestCandidates(refinement, searched, given.empty() ? settings.contenders : settings.later_contenders,
                          settings.contender_margin);
    const std::vector<const SymmetryCandidate*> known = allOf(given);
    all.insert(all.end(), known.begin(), known.end());
    return all;
  }
};

bool
listsOthers(const SymmetryParameters& parameters)
{
  return parameters.alternatives > 1 && !parameters.sparse_only;
}

/** Lists the symmetries that a search has found, that of a contender first: the same as that of a map, which may be more
 * precise. */
void
listOthers(const SampledSurface& sampled,
           const SampleRefinement& refinement,
           const Contender& first,
           const std::vector<SymmetryCandidate>& candidates,
           const SymmetryParameters& parameters,
           const RobustSettings& settings,
           MapEstimate& map)
{
  map.alternatives.clear();
  map.rotations.clear();
  deliverAlternatives(sampled, refinement, MapJudge(sampled), first, candidates, settings.search,
                      static_cast<std::size_t>(parameters.alternatives), map);
  map.alternatives.front().partners = map.partners;
}

/** Maps that differ from a contender in where two limbs go, and come as close as contenders must. */
std::vector<SymmetryCandidate>
promisingExchanges(const SampledSurface& sampled,
                   const std::vector<Contender>& contenders,
                   const std::vector<SymmetryCandidate>& candidates,
                   const RobustSettings& settings)
{
  std::vector<SampleMap> maps(contenders.size());
  std::transform(contenders.begin(), contenders.end(), maps.begin(),
                 [](const Contender& contender) { return contender.samples.landmark_map; });
  std::vector<SymmetryCandidate> exchanged = exchangeLimbs(sampled, maps, settings.search, settings.exchange);
  const float worst = candidates.front().score.value + settings.contender_margin;
  exchanged.erase(std::remove_if(exchanged.begin(), exchanged.end(),
                                 [worst](const SymmetryCandidate& c) { return c.score.value > worst; }),
                  exchanged.end());
  return exchanged;
}

} // namespace

RobustSettings
robustSettings(const SymmetryParameters& parameters, float samples)
{
  RobustSettings settings;
  const auto usual = static_cast<float>(parameters.robust.samples);
  settings.sampling.samples = std::max(minimum_samples, static_cast<std::size_t>(std::lround(samples * usual)));
  return settings;
}

MapEstimate
estimateRobust(const PreparedSurface& surface,
               const SymmetryParameters& parameters,
               const RobustSettings& settings,
               StepTimer& timer,
               const std::vector<std::vector<Index>>& known)
{
  if (surface.size() < minimum_points) {
    return tooFewPoints();
  }
  // Sample: evenly spaced samples, their eigenfunctions, the distances between the first of them, their features.
  const SampledSurface sampled = sampleSurface(surface, settings.sampling, parameters.metric, timer);
  if (sampled.coarse.size() < minimum_samples) {
    return tooFewPoints();
  }
  // Mirror: what is its own mirror image in space needs no search; that of several parts is rarely anything else, and
  // where several planes fit equally well a search would take any one.
  const std::vector<MirrorFit> planes = mirrorPlanesOf(sampled, settings.mirror);
  const bool is_whole = !planes.empty() && !planes.front().is_of_part;
  if (is_whole && (!surface.part_of.empty() || haveEqualFits(planes))) {
    timer.start("dense", 0.8);
    return estimateByMirror(sampled, planes, parameters, settings.mirror);
  }
  // Search: many hypotheses among the landmarks, ranked.
  timer.start("hypotheses", 0.4);
  const Hypotheses hypotheses{searchSymmetries(sampled, settings.search),
                              candidatesFromMaps(sampled, landmarkMapsOf(sampled, known), settings.search)};
  const MapJudge judge(sampled);
  std::vector<Contender> contenders;
  if (planes.empty() && hypotheses.bestScore() >= settings.score_to_beat) {
    return judge.verdict(contenders);
  }

  // Refine: the candidates that come close, to the precision of the surface.
  timer.start("matching", 0.7);
  const SampleRefinement refinement(sampled, settings.refinement);
  addContenders(refinement, hypotheses.promising(refinement, settings), contenders);

  // Judge: which of them fits best, and whether it is a symmetry at all.
  MapEstimate estimate = judge.verdict(contenders);
  if (!planes.empty() && explainsMore(planes.front(), sampled, contenders, estimate, settings.mirror)) {
    timer.start("dense", 0.8);
    MapEstimate mirrored = estimateByMirror(sampled, planes, parameters, settings.mirror);
    // What it leaves out may be a pose: among interpretations it counts no more than the map it is preferred to.
    mirrored.misfit = planes.front().is_of_part ? estimate.misfit : mirrored.misfit;
    if (is_whole && estimate.confidence >= in_doubt && listsOthers(parameters) &&
        !compareWithPlane(sampled, contenders.front().samples, planes.front(), settings.mirror).contradicts) {
      listOthers(sampled, refinement, contenders.front(), hypotheses.searched, parameters, settings, mirrored);
    }
    return mirrored;
  }
  if (contenders.empty()) {
    return estimate;
  }
  // In doubt: is it right but for two limbs? Ends of an object in parts are none.
  std::vector<SymmetryCandidate> exchanged;
  if (estimate.confidence < in_doubt && surface.part_of.empty() && known.empty()) {
    exchanged = promisingExchanges(sampled, contenders, hypotheses.searched, settings);
  }
  if (!exchanged.empty()) {
    addContenders(refinement, allOf(exchanged), contenders);
    estimate = judge.verdict(contenders);
  }
  if (settings.observer) {
    settings.observer(sampled, contenders);
  }
  estimate.search_score = hypotheses.bestScore();
  // Deliver: from the samples to all points, also where the map is refused: other interpretations may speak for it.
  timer.start("dense", 0.8);
  deliverMap(sampled, contenders.front().samples, estimate);
  if (listsOthers(parameters)) {
    listOthers(sampled, refinement, contenders.front(), hypotheses.searched, parameters, settings, estimate);
  }
  return estimate;
}

} // namespace symmetry
} // namespace pcl
