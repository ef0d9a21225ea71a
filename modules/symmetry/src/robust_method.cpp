#include "symmetry/robust_method.h"

#include "base/parallel.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/confidence/distinct_symmetries.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/samples/sample_interpolation.h"
#include "symmetry/sides/limb_regions.h"
#include "symmetry/sides/side_votes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t fewest_points = 60;
constexpr std::size_t fewest_samples = 30;

/** Everything about a surface that does not depend on a map. */
struct SurfaceModel {
  CoarseSurface coarse;
  LaplacianBasis basis;
  LandmarkSurface landmarks;
};

/** Votes of the ordered pairs at every sample, carried over to the points and made antisymmetric under the map. */
std::vector<float>
pointSides(const SurfaceModel& model,
           const OrderedPairs& pairs,
           const SampleInterpolation& interpolation,
           const std::vector<Index>& partners,
           unsigned threads)
{
  const DistanceFields from_sources = distanceFields(model.coarse.graph, pairs.sources, threads);
  const DistanceFields from_targets = distanceFields(model.coarse.graph, pairs.targets, threads);
  std::vector<float> votes(model.coarse.size(), 0.0F);
  for (std::size_t k = 0; k < pairs.sources.size(); ++k) {
    const float apart = from_sources.row(k)[pairs.targets[k]] * static_cast<float>(pairs.sources.size());
    for (std::size_t i = 0; i < votes.size(); ++i) {
      votes[i] += (from_targets.row(k)[i] - from_sources.row(k)[i]) / apart;
    }
  }
  std::vector<float> at_points(interpolation.offsets.size() - 1);
  for (std::size_t v = 0; v < at_points.size(); ++v) {
    at_points[v] = interpolation.at(v, votes);
  }
  std::vector<float> sides = at_points;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    sides[v] = 0.5F * (at_points[v] - at_points[partners[v]]);
  }
  return sides;
}

/** One match for every landmark on the source side that moves, with the landmark nearest to the middle of the way. */
std::vector<SymmetricMatch>
sparseMatches(const SurfaceModel& model,
              const SampleMap& map,
              const std::vector<Index>& points_of_partners,
              const std::vector<float>& sides)
{
  constexpr std::size_t most = 100;
  constexpr float least_distance = 0.05F;
  const LandmarkSurface& landmarks = model.landmarks;
  std::vector<SymmetricMatch> matches;
  for (std::size_t i = 0; i < landmarks.size() && matches.size() < most; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Index partner = model.landmarks.nearest_landmark[map[i]];
    const Index point = model.coarse.cells.vertices[i];
    const float apart = landmarks.distances(row, partner);
    if (apart < least_distance * landmarks.diameter || sides[point] <= 0.0F) {
      continue;
    }
    Eigen::Index middle = 0;
    (landmarks.distances.col(row).cwiseMax(landmarks.distances.col(partner))).minCoeff(&middle);
    const float change =
        (landmarks.distances(partner, row) - landmarks.distances(row, model.landmarks.nearest_landmark[map[partner]])) /
        landmarks.diameter;
    matches.push_back({point, points_of_partners[i], model.coarse.cells.vertices[static_cast<std::size_t>(middle)],
                       std::abs(change)});
  }
  return matches;
}

/** Region of every point and the ends of the limbs. */
void
describeLimbs(const SurfaceModel& model,
              const SampleMap& landmark_map,
              const OrderedPairs& pairs,
              MapEstimate& estimate)
{
  const auto limbs = swappedExtremities(model.landmarks, landmark_map, pairs);
  const std::vector<Region> landmark_regions = hubRegions(model.landmarks, limbs);
  for (const Index cell : model.coarse.cells.owner) {
    estimate.regions.push_back(landmark_regions[model.landmarks.nearest_landmark[cell]]);
  }
  for (const auto& [source, target] : limbs) {
    estimate.extremities.push_back(model.coarse.cells.vertices[source]);
    estimate.extremities.push_back(model.coarse.cells.vertices[target]);
  }
}

/** Candidates in their order, but one of them first. */
std::vector<SymmetryCandidate>
withFirst(const SymmetryCandidate& first, const std::vector<SymmetryCandidate>& candidates)
{
  std::vector<SymmetryCandidate> ordered{first};
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(ordered),
               [&](const SymmetryCandidate& candidate) { return &candidate != &first; });
  return ordered;
}

/** A candidate and what became of it. */
struct Contender {
  const SymmetryCandidate* candidate = nullptr;
  SampleEstimate samples;
  float confidence = 0.0F;
};

/** From candidates among the landmarks to maps of all points. */
class RobustEstimation {
public:
  /** All that is given is referred to, not copied. */
  RobustEstimation(const PreparedSurface& surface,
                   const SurfaceModel& model,
                   const SymmetryParameters& parameters,
                   const RobustSettings& settings)
      : surface_(surface),
        model_(model),
        parameters_(parameters),
        settings_(settings),
        interpolation_(interpolateFromSamples(surface, model.coarse, parameters.threads)),
        members_(membersOfCells(model.coarse)),
        probes_(thinnedMembers(members_, settings.refinement.probes)),
        spacing_(surface.is_cloud ? measureSpacing(surface.graph, model.coarse.cells.vertices, model.landmarks.diameter)
                                  : PointSpacing{}),
        share_at_holes_(static_cast<float>(std::count(model.coarse.at_hole.begin(), model.coarse.at_hole.end(), 1)) /
                        static_cast<float>(model.coarse.size())),
        descriptor_(describeShape(model.coarse, model.basis, settings.search.dimensions, settings.search.descriptor)),
        refinement_(surface,
                    model.coarse,
                    model.basis,
                    model.landmarks,
                    interpolation_,
                    members_,
                    settings.refinement,
                    parameters.threads)
  {
  }

  /** Of the candidates with the best scores, refined, the one that fits best; of a cloud, see bestTrustedMap (). */
  Contender
  bestContender(const std::vector<SymmetryCandidate>& candidates) const
  {
    std::vector<Contender> contenders = refinedContenders(candidates);
    Contender& first = contenders.front();
    first.confidence = confidenceOf(*first.candidate, first.samples);
    const float least = leastMapConfidence(knownHoles());
    if (!surface_.is_cloud || first.confidence >= least) {
      return std::move(first);
    }
    std::vector<RatedMap> maps;
    maps.reserve(contenders.size());
    for (const Contender& contender : contenders) {
      maps.push_back({contender.samples.value, confidenceOf(*contender.candidate, contender.samples)});
    }
    const auto [number, confidence] = bestTrustedMap(maps, least);
    contenders[number].confidence = confidence;
    return std::move(contenders[number]);
  }

  /** Share of the samples at holes where faces tell: sparse points have gaps that look alike. */
  float
  knownHoles() const
  {
    return surface_.is_cloud && !surface_.summary.read_as_cloud ? 0.0F : share_at_holes_;
  }

  float
  confidenceOf(const SymmetryCandidate& candidate, const SampleEstimate& samples) const
  {
    return mapConfidence({samples.score, candidate.score.curvature,
                          findAsymmetry(model_.landmarks, descriptor_.curvature, samples.landmark_map), samples.fit,
                          samples.worst_distance, surface_.summary.smoothing_radius > 0.0F, share_at_holes_, spacing_});
  }

  /** Carries a map of the samples over to all points: partners, sides, confidences, sparse matches, limbs.
   * \param[in,out] estimate with the confidence of the map */
  void
  describeMap(const SampleEstimate& samples, MapEstimate& estimate) const
  {
    estimate.partners = partnersOf(samples);
    const OrderedPairs pairs = orderPairs(model_.landmarks, samples.landmark_map);
    estimate.side_function = pointSides(model_, pairs, interpolation_, estimate.partners, parameters_.threads);
    estimate.matches = sparseMatches(model_, samples.map, samples.partners, estimate.side_function);
    estimate.confidences =
        pointConfidences(model_.landmarks, model_.coarse, samples.map, interpolation_, estimate.confidence);
    describeLimbs(model_, samples.landmark_map, pairs, estimate);
  }

  /** Dense maps of the symmetries among the candidates, as many as were asked for. */
  void
  appendAlternatives(const std::vector<SymmetryCandidate>& candidates, MapEstimate& estimate) const
  {
    if (parameters_.alternatives <= 1 || parameters_.sparse_only) {
      return;
    }
    const DistinctSymmetries distinct = distinctSymmetries(model_.landmarks, descriptor_, candidates, settings_.search,
                                                           static_cast<std::size_t>(parameters_.alternatives));
    for (const DistinctReflection& reflection : distinct.reflections) {
      const SampleEstimate samples = refinement_.refine(reflection.candidate);
      const float confidence = estimate.alternatives.empty() ? estimate.confidence // of the map itself
                                                             : confidenceOf(reflection.candidate, samples);
      estimate.alternatives.push_back({partnersOf(samples), reflection.candidate.score.value, confidence, true});
    }
    for (const DistinctRotation& rotation : distinct.rotations) {
      const std::vector<Index>& second = estimate.alternatives[rotation.second].partners;
      std::vector<Index> images = estimate.alternatives[rotation.first].partners;
      std::transform(images.begin(), images.end(), images.begin(), [&](Index image) { return second[image]; });
      estimate.rotations.push_back({std::move(images), rotation.score.value, rotation.confidence, false});
    }
  }

private:
  /** The candidates with the best scores, refined; what fits best comes first. */
  std::vector<Contender>
  refinedContenders(const std::vector<SymmetryCandidate>& candidates) const
  {
    std::vector<Contender> contenders;
    for (const SymmetryCandidate& candidate : candidates) {
      if (!contenders.empty() && (contenders.size() >= settings_.contenders ||
                                  candidate.score.value > candidates[0].score.value + settings_.contender_margin)) {
        break;
      }
      contenders.push_back({&candidate, refinement_.refine(candidate), 0.0F});
    }
    std::stable_sort(contenders.begin(), contenders.end(),
                     [](const Contender& a, const Contender& b) { return a.samples.value < b.samples.value; });
    return contenders;
  }

  std::vector<Index>
  partnersOf(const SampleEstimate& samples) const
  {
    return partnersOfPoints(surface_, model_.coarse, probes_, samples.partners, parameters_.threads);
  }

  const PreparedSurface& surface_;
  const SurfaceModel& model_;
  const SymmetryParameters& parameters_;
  const RobustSettings& settings_;
  SampleInterpolation interpolation_;
  CellMembers members_;
  CellMembers probes_;   ///< some of them
  PointSpacing spacing_; ///< of a cloud
  float share_at_holes_; ///< of the samples
  ShapeDescriptor descriptor_;
  SampleRefinement refinement_;
};

SurfaceModel
modelSurface(const PreparedSurface& surface,
             const SymmetryParameters& parameters,
             const RobustSettings& settings,
             StepTimer& timer)
{
  SurfaceModel model;
  timer.start("sampling", 0.1);
  const std::size_t samples = parameters.samples > 0 ? static_cast<std::size_t>(parameters.samples) : settings.samples;
  model.coarse = coarsenSurface(surface, samples);
  if (model.coarse.size() < fewest_samples) {
    return model;
  }
  timer.start("embedding", 0.2);
  model.basis = laplacianBasis(model.coarse, settings.eigenfunctions);
  timer.start("geodesics", 0.3);
  model.landmarks = makeLandmarkSurface(model.coarse, settings.landmarks, parameters.metric, parameters.threads);
  return model;
}

} // namespace

MapEstimate
estimateRobust(const PreparedSurface& surface,
               const SymmetryParameters& parameters,
               const RobustSettings& settings,
               StepTimer& timer)
{
  MapEstimate estimate;
  estimate.status = SymmetryStatus::TooFewPoints;
  estimate.message = "the robust method needs " + std::to_string(fewest_points) + " connected points, " +
                     std::to_string(fewest_samples) + " of them at distinct places";
  if (surface.size() < fewest_points) {
    return estimate;
  }
  const SurfaceModel model = modelSurface(surface, parameters, settings, timer);
  if (model.coarse.size() < fewest_samples) {
    return estimate;
  }
  estimate.status = SymmetryStatus::NoSymmetry;
  estimate.message = "no map explains the surface as a reflection of itself";
  estimate.diameter = model.landmarks.diameter;

  timer.start("hypotheses", 0.4);
  const std::vector<SymmetryCandidate> candidates =
      searchSymmetries(model.coarse, model.basis, model.landmarks, settings.search, parameters.threads);
  if (candidates.empty()) {
    return estimate;
  }
  timer.start("matching", 0.7);
  const RobustEstimation estimation(surface, model, parameters, settings);
  const Contender best = estimation.bestContender(candidates);
  estimate.known_holes = estimation.knownHoles();
  estimate.confidence = confidence_of_refused * best.confidence;
  if (best.confidence < leastMapConfidence(estimate.known_holes)) {
    if (isReflection(best.samples.score) || isReflection(best.candidate->score)) {
      estimate.message = "the best reflection of the surface fails in one place: one side has what the other lacks";
    }
    return estimate;
  }
  estimate.status = SymmetryStatus::Symmetric;
  estimate.message.clear();
  estimate.confidence = best.confidence;

  timer.start("dense", 0.8);
  estimation.describeMap(best.samples, estimate);
  estimation.appendAlternatives(withFirst(*best.candidate, candidates), estimate);
  return estimate;
}

} // namespace symmetry
} // namespace pcl
