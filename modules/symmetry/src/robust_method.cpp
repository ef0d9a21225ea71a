#include "symmetry/robust_method.h"

#include "geodesic/parallel.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/distinct_symmetries.h"
#include "symmetry/hub_regions.h"
#include "symmetry/map_confidence.h"
#include "symmetry/pair_votes.h"
#include "symmetry/point_map.h"
#include "symmetry/sample_interpolation.h"

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
  HubSurface hubs;
};

/** What it takes to carry a map of the samples over to the points. */
struct PointTransfer {
  SampleInterpolation interpolation;
  CellMembers members;
  CellMembers probes; ///< some of them
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

/** One match for every hub on the source side that moves, with the hub nearest to the middle of the way. */
std::vector<SymmetricMatch>
sparseMatches(const SurfaceModel& model,
              const SampleMap& map,
              const std::vector<Index>& points_of_partners,
              const std::vector<float>& sides)
{
  constexpr std::size_t most = 100;
  constexpr float least_distance = 0.05F;
  const HubSurface& hubs = model.hubs;
  std::vector<SymmetricMatch> matches;
  for (std::size_t i = 0; i < hubs.size() && matches.size() < most; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Index partner = model.hubs.nearest_hub[map[i]];
    const Index point = model.coarse.cells.vertices[i];
    const float apart = hubs.distances(row, partner);
    if (apart < least_distance * hubs.diameter || sides[point] <= 0.0F) {
      continue;
    }
    Eigen::Index middle = 0;
    (hubs.distances.col(row).cwiseMax(hubs.distances.col(partner))).minCoeff(&middle);
    const float change =
        (hubs.distances(partner, row) - hubs.distances(row, model.hubs.nearest_hub[map[partner]])) / hubs.diameter;
    matches.push_back({point, points_of_partners[i], model.coarse.cells.vertices[static_cast<std::size_t>(middle)],
                       std::abs(change)});
  }
  return matches;
}

/** Region of every point and the ends of the limbs. */
void
describeLimbs(const SurfaceModel& model, const SampleMap& hub_map, const OrderedPairs& pairs, MapEstimate& estimate)
{
  const auto limbs = swappedExtremities(model.hubs, hub_map, pairs);
  const std::vector<Region> hub_regions = hubRegions(model.hubs, limbs);
  for (const Index cell : model.coarse.cells.owner) {
    estimate.regions.push_back(hub_regions[model.hubs.nearest_hub[cell]]);
  }
  for (const auto& [source, target] : limbs) {
    estimate.extremities.push_back(model.coarse.cells.vertices[source]);
    estimate.extremities.push_back(model.coarse.cells.vertices[target]);
  }
}

float
confidenceOf(const SampleEstimate& samples, const SurfaceModel& model, const ShapeDescriptor& descriptor, bool is_noisy)
{
  return mapConfidence({samples.score, findAsymmetry(model.hubs, descriptor.curvature, samples.hub_map), samples.fit,
                        sampleSpacing(model.coarse) / model.hubs.diameter, is_noisy});
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

/** Dense maps of the symmetries among the candidates, as many as were asked for. */
void
appendAlternatives(const PreparedSurface& surface,
                   const SurfaceModel& model,
                   const ShapeDescriptor& descriptor,
                   const PointTransfer& transfer,
                   const SampleRefinement& refinement,
                   const std::vector<SymmetryCandidate>& candidates,
                   const SymmetryParameters& parameters,
                   const RobustSettings& settings,
                   MapEstimate& estimate)
{
  if (parameters.alternatives <= 1) {
    return;
  }
  const DistinctSymmetries distinct = distinctSymmetries(model.hubs, descriptor, candidates, settings.search,
                                                         static_cast<std::size_t>(parameters.alternatives));
  for (const DistinctReflection& reflection : distinct.reflections) {
    const SampleEstimate samples = refinement.refine(reflection.candidate);
    estimate.alternatives.push_back(
        {partnersOfPoints(surface, model.coarse, transfer.probes, samples.partners, parameters.threads),
         reflection.candidate.score.value,
         confidenceOf(samples, model, descriptor, surface.summary.smoothing_radius > 0.0F), true});
  }
  for (const DistinctRotation& rotation : distinct.rotations) {
    const std::vector<Index>& second = estimate.alternatives[rotation.second].partners;
    std::vector<Index> images = estimate.alternatives[rotation.first].partners;
    std::transform(images.begin(), images.end(), images.begin(), [&](Index image) { return second[image]; });
    estimate.rotations.push_back({std::move(images), rotation.score.value, rotation.confidence, false});
  }
}

/** A candidate and what became of it. */
struct Contender {
  const SymmetryCandidate* candidate = nullptr;
  SampleEstimate samples;
};

/** Of the candidates with the best scores, refined, the one that fits best. */
Contender
bestContender(const SampleRefinement& refinement,
              const std::vector<SymmetryCandidate>& candidates,
              const RobustSettings& settings)
{
  Contender best;
  for (std::size_t i = 0; i < std::min(settings.contenders, candidates.size()); ++i) {
    if (i > 0 && candidates[i].score.value > candidates[0].score.value + settings.contender_margin) {
      break;
    }
    SampleEstimate estimate = refinement.refine(candidates[i]);
    if (i == 0 || estimate.value < best.samples.value) {
      best = {&candidates[i], std::move(estimate)};
    }
  }
  return best;
}

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
  model.hubs = makeHubSurface(model.coarse, settings.hubs, parameters.metric, parameters.threads);
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
  estimate.diameter = model.hubs.diameter;

  timer.start("hypotheses", 0.4);
  const std::vector<SymmetryCandidate> candidates =
      searchSymmetries(model.coarse, model.basis, model.hubs, settings.search, parameters.threads);
  if (candidates.empty()) {
    return estimate;
  }
  timer.start("matching", 0.7);
  PointTransfer transfer{
      interpolateFromSamples(surface, model.coarse, parameters.threads), membersOfCells(model.coarse), {}};
  transfer.probes = thinnedMembers(transfer.members, settings.refinement.probes);
  const SampleRefinement refinement(surface, model.coarse, model.basis, model.hubs, transfer.interpolation,
                                    transfer.members, settings.refinement, parameters.threads);
  const Contender contender = bestContender(refinement, candidates, settings);
  const SampleEstimate& best = contender.samples;
  const MapScore& score = best.score.value < contender.candidate->score.value ? best.score : contender.candidate->score;
  const ShapeDescriptor descriptor =
      describeShape(model.coarse, model.basis, settings.search.dimensions, settings.search.descriptor);
  const bool is_noisy = surface.summary.smoothing_radius > 0.0F;
  const float confidence = confidenceOf(best, model, descriptor, is_noisy);
  estimate.confidence = confidence_of_refused * confidence;
  if (!isReflection(score)) {
    return estimate;
  }
  if (confidence < least_map_confidence) {
    estimate.message = "the best reflection of the surface fails in one place: one side has what the other lacks";
    return estimate;
  }
  estimate.confidence = confidence;
  estimate.status = SymmetryStatus::Symmetric;
  estimate.message.clear();

  timer.start("dense", 0.8);
  if (!parameters.sparse_only) {
    estimate.partners = partnersOfPoints(surface, model.coarse, transfer.probes, best.partners, parameters.threads);
    appendAlternatives(surface, model, descriptor, transfer, refinement, withFirst(*contender.candidate, candidates),
                       parameters, settings, estimate);
  }
  const OrderedPairs pairs = orderPairs(model.hubs, best.hub_map);
  estimate.side_function = pointSides(model, pairs, transfer.interpolation, estimate.partners, parameters.threads);
  estimate.matches = sparseMatches(model, best.map, best.partners, estimate.side_function);
  estimate.confidences =
      pointConfidences(model.hubs, model.coarse, best.map, transfer.interpolation, estimate.confidence);
  describeLimbs(model, best.hub_map, pairs, estimate);
  return estimate;
}

} // namespace symmetry
} // namespace pcl
