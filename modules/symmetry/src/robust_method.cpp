#include "symmetry/robust_method.h"

#include "geodesic/parallel.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/hub_regions.h"
#include "symmetry/map_confidence.h"
#include "symmetry/pair_votes.h"
#include "symmetry/point_map.h"
#include "symmetry/sample_interpolation.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t fewest_points = 60;

/** Everything about a surface that does not depend on a map. */
struct SurfaceModel {
  CoarseSurface coarse;
  LaplacianBasis basis;
  HubSurface hubs;
};

/** A map of all samples with what is derived from it. */
struct SampleEstimate {
  SampleMap map;
  Eigen::MatrixXf matrix;
};

/** Extends the map of the hubs to all samples and refines it among them. */
SampleEstimate
refineOnAllSamples(const SurfaceModel& model, const SymmetryCandidate& candidate, const RobustSettings& settings)
{
  const auto count = static_cast<Eigen::Index>(model.coarse.size());
  const Eigen::MatrixXf functions = model.basis.functions.leftCols(candidate.matrix.cols());
  SampleEstimate estimate;
  estimate.map = nearestRows(functions * candidate.matrix, functions);
  DescriptorWeights weights = settings.search.descriptor;
  weights.oriented_dimensions = settings.search.guide_dimensions;
  const ShapeDescriptor guide = describeShape(model.coarse, model.basis, settings.search.guide_dimensions, weights);
  const UpwardRefinement refinement(model.basis.functions, guide, count, settings.final_levels, 0.0F);
  estimate.matrix = refinement.refine(estimate.map);
  return estimate;
}

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

} // namespace

MapEstimate
estimateRobust(const PreparedSurface& surface,
               const SymmetryParameters& parameters,
               const RobustSettings& settings,
               StepTimer& timer)
{
  MapEstimate estimate;
  if (surface.size() < fewest_points) {
    estimate.status = SymmetryStatus::TooFewPoints;
    estimate.message = "fewer than " + std::to_string(fewest_points) + " usable points";
    return estimate;
  }
  SurfaceModel model;
  timer.start("sampling", 0.05);
  const std::size_t samples = parameters.samples > 0 ? static_cast<std::size_t>(parameters.samples) : settings.samples;
  model.coarse = coarsenSurface(surface, samples);
  timer.start("embedding", 0.2);
  model.basis = laplacianBasis(model.coarse, settings.eigenfunctions);
  timer.start("geodesics", 0.3);
  model.hubs = makeHubSurface(model.coarse, settings.hubs, parameters.metric, parameters.threads);
  timer.start("hypotheses", 0.4);
  const std::vector<SymmetryCandidate> candidates =
      searchSymmetries(model.coarse, model.basis, model.hubs, settings.search, parameters.threads);
  if (candidates.empty()) {
    estimate.message = "the surface is too simple to tell any symmetry";
    return estimate;
  }
  timer.start("matching", 0.7);
  const SampleEstimate best = refineOnAllSamples(model, candidates[0], settings);

  timer.start("dense", 0.8);
  const SampleInterpolation interpolation = interpolateFromSamples(surface, model.coarse, parameters.threads);
  const CellMembers members = membersOfCells(model.coarse);
  const std::vector<Index> sample_partners =
      partnersOfSamples(model.coarse, model.basis, interpolation, members, best.map, best.matrix, parameters.threads);
  if (!parameters.sparse_only) {
    estimate.partners =
        partnersOfPoints(surface, model.coarse, interpolation, members, sample_partners, parameters.threads);
  }
  const OrderedPairs pairs = orderPairs(model.hubs, candidates[0].map);
  estimate.side_function = pointSides(model, pairs, interpolation, estimate.partners, parameters.threads);
  estimate.matches = sparseMatches(model, best.map, sample_partners, estimate.side_function);

  const auto limbs = swappedExtremities(model.hubs, candidates[0].map, pairs);
  const std::vector<Region> hub_regions = hubRegions(model.hubs, limbs);
  estimate.regions.resize(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    estimate.regions[v] = hub_regions[model.hubs.nearest_hub[model.coarse.cells.owner[v]]];
  }
  for (const auto& [source, target] : limbs) {
    estimate.extremities.push_back(model.coarse.cells.vertices[source]);
    estimate.extremities.push_back(model.coarse.cells.vertices[target]);
  }
  estimate.diameter = model.hubs.diameter;
  estimate.confidence = reflectionConfidence(candidates[0].score);
  estimate.confidences = pointConfidences(model.hubs, model.coarse, best.map, interpolation, estimate.confidence);
  estimate.status = isReflection(candidates[0].score) ? SymmetryStatus::Symmetric : SymmetryStatus::NoSymmetry;
  if (estimate.status == SymmetryStatus::NoSymmetry) {
    estimate.message = "no map explains the surface as a reflection of itself";
  }
  return estimate;
}

} // namespace symmetry
} // namespace pcl
