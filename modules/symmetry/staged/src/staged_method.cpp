#include "symmetry/staged/staged_method.h"

#include "base/centroid.h"
#include "geodesic/surface_metric.h"
#include "symmetry/sides/sides.h"
#include "symmetry/staged/base_vertices.h"
#include "symmetry/staged/dense_map.h"
#include "symmetry/staged/extreme_pairs.h"
#include "symmetry/staged/extremities.h"
#include "symmetry/staged/regions.h"
#include "symmetry/staged/spectral_embedding.h"
#include "symmetry/staged/stage_matching.h"
#include "symmetry/staged/staged_confidence.h"
#include "symmetry/staged/staged_settings.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace pcl {
namespace symmetry {
namespace {

constexpr StageSettings settings{};
constexpr ExtremitySettings extremity_settings{};

std::unique_ptr<SurfaceMetric>
makeMetric(const PreparedSurface& surface, Metric metric)
{
  if (metric == Metric::Euclidean) {
    return std::make_unique<EuclideanMetric>(surface.points);
  }
  return std::make_unique<GeodesicMetric>(surface.graph);
}

float
largestDistance(const DistanceFields& fields, const std::vector<Index>& landmarks)
{
  float largest = 0.0F;
  for (std::size_t i = 0; i < fields.rows(); ++i) {
    for (const Index landmark : landmarks) {
      largest = std::max(largest, fields.row(i)[landmark]);
    }
  }
  return largest;
}

/** The tips of two pairs of limbs; nothing where there are no four extreme points. */
std::optional<ExtremePairs>
findExtremePairs(const SurfaceGraph& embedded,
                 Index start,
                 const ExtremityFunctions& functions,
                 const SurfaceMetric& metric,
                 const std::vector<Index>& landmarks,
                 const SymmetryParameters& parameters)
{
  const bool first_four = parameters.staged.extremities == ExtremePoints::FirstFour;
  const std::vector<Index> points =
      mutuallyFarthestVertices(embedded, start, first_four ? 4 : extremity_settings.candidates);
  if (points.size() < 4) {
    return std::nullopt;
  }
  const std::vector<float>& feature = pairingFeature(functions, parameters.staged.pairing);
  if (first_four) {
    return pairExtremePoints({points[0], points[1], points[2], points[3]}, feature, metric, landmarks);
  }
  return chooseExtremePairs(points, feature, metric, landmarks);
}

/** m_hf: the midpoint of the path between the midpoints of h1-f1 and h2-f2. */
Index
middleOfSides(const ExtremePairs& pairs, const SurfaceMetric& metric)
{
  const std::vector<Index> h = {pairs.h1, pairs.h2};
  const std::vector<Index> of_side = metric.midpoints(h, metric.fields(h), {pairs.f1, pairs.f2});
  return metric.midpoints({of_side[0]}, metric.fields({of_side[0]}), {of_side[1]}).front();
}

/** Evenly spaced samples of the source limbs and the centre. */
std::vector<Index>
sampleSourceAndCentre(const SurfaceMetric& metric, Index start, std::size_t count, const std::vector<Region>& regions)
{
  // The target limbs take at most about as many samples as the source limbs do: thrice the number is plenty.
  std::vector<Index> samples = metric.farthestPoints(start, 3 * count);
  const auto on_target = [&regions](Index v) {
    return regions[v] == Region::Target1 || regions[v] == Region::Target2;
  };
  samples.erase(std::remove_if(samples.begin(), samples.end(), on_target), samples.end());
  samples.resize(std::min(samples.size(), count));
  return samples;
}

std::vector<SymmetricMatch>
withoutSameSide(std::vector<SymmetricMatch> matches, const std::vector<float>& sides)
{
  const auto same_side = [&sides](const SymmetricMatch& match) {
    return (sides[match.source] > 0.0F) == (sides[match.target] > 0.0F);
  };
  matches.erase(std::remove_if(matches.begin(), matches.end(), same_side), matches.end());
  return matches;
}

/** Stages 1 to 4 (section 3.3): each matches more vertices than the one before it and adds what it trusts to the base.
 */
std::vector<SymmetricMatch>
matchInStages(BaseVertices& base,
              const ExtremityFunctions& extremities,
              const std::vector<Region>& regions,
              const std::vector<Index>& samples)
{
  for (const std::vector<Index>* stage_extremities :
       {&extremities.average_maxima, &extremities.minimal_maxima}) { // stages 1 and 2
    std::vector<SymmetricMatch> matches =
        matchExtremities(base, regions, *stage_extremities, settings.kept_extremities);
    base.addPairs(matches);
  }

  std::vector<float> sides = sideFunction(base.sourceFields(), base.targetFields());
  std::vector<SymmetricMatch> third =
      matchSamples(base, regions, sides, samples, FeatureSet::Midpoints, settings.kept_in_stage_3);
  base.addPairs(third);

  sides = sideFunction(base.sourceFields(), base.targetFields());
  return withoutSameSide(
      matchSamples(base, regions, sides, samples, FeatureSet::OwnEndpointsAndMidpoints, settings.kept_in_stage_4),
      sides);
}

MapEstimate
tooFewPoints(std::size_t points)
{
  MapEstimate estimate;
  estimate.status = SymmetryStatus::TooFewPoints;
  estimate.message = "the staged method needs " + std::to_string(settings.minimum_points) +
                     " connected points, there are " + std::to_string(points);
  return estimate;
}

/** Dense map: every vertex matched with the base of the last stage. */
void
matchEveryVertex(const PreparedSurface& surface, const BaseVertices& base, MapEstimate& estimate)
{
  DenseMap map = denseMap(base, estimate.side_function);
  estimate.confidence *= involutionShare(surface.points, map.partners, estimate.diameter);
  estimate.confidences =
      vertexConfidences(surface.points, map, base.dimensions(), estimate.diameter, estimate.confidence);
  estimate.partners = std::move(map.partners);
}

/** Whether the map is a symmetry. */
void
judge(MapEstimate& estimate)
{
  if (estimate.confidence >= minimum_trusted_confidence) {
    estimate.status = SymmetryStatus::Symmetric;
  }
  else {
    estimate.message = "the best map found changes distances too much, or is too far from its own inverse, to be a "
                       "symmetry: its confidence is " +
                       std::to_string(estimate.confidence);
  }
}

} // namespace

MapEstimate
estimateStaged(const PreparedSurface& surface, const SymmetryParameters& parameters, StepTimer& timer)
{
  if (surface.size() < settings.minimum_points) {
    return tooFewPoints(surface.size());
  }
  const std::unique_ptr<SurfaceMetric> metric = makeMetric(surface, parameters.metric);
  MapEstimate estimate;

  timer.start("sampling", 0.0);
  const Index start = farthestFromCentroid(surface.points);
  const std::vector<Index> landmarks =
      metric->farthestPoints(start, static_cast<std::size_t>(parameters.staged.landmarks));

  timer.start("geodesics", 0.02);
  DistanceFields fields = metric->fields(landmarks);
  estimate.diameter = largestDistance(fields, landmarks);

  timer.start("embedding", 0.15); // section 3.1
  const SpectralEmbedding embedding = embedByLandmarks(fields, landmarks, parameters.staged.embedding_dimensions);
  fields = {};

  timer.start("hypotheses", 0.2);
  const SurfaceGraph embedded = embeddedGraph(surface.graph, embedding);
  const ExtremityFunctions functions =
      extremityFunctions(embedded, start, settings.average_samples, settings.extremity_separation * estimate.diameter);
  const std::optional<ExtremePairs> pairs =
      findExtremePairs(embedded, start, functions, *metric, landmarks, parameters);
  if (!pairs) {
    estimate.message = "fewer than four distinct extreme points: the staged method needs two pairs of limbs";
    return estimate;
  }
  estimate.extremities = {pairs->h1, pairs->h2, pairs->f1, pairs->f2};
  std::vector<SymmetricMatch> limbs = {{pairs->h1, pairs->h2, no_index, 0.0F}, {pairs->f1, pairs->f2, no_index, 0.0F}};
  BaseVertices base(*metric);
  base.addPairs(limbs);
  base.addMidpoint(middleOfSides(*pairs, *metric));
  estimate.regions = limbRegions(base.sourceFields(), base.targetFields(), limbs[0].midpoint, limbs[1].midpoint);

  timer.start("matching", 0.35); // section 3.3
  const auto count = static_cast<std::size_t>(parameters.staged.samples);
  const std::vector<Index> samples = sampleSourceAndCentre(*metric, start, count, estimate.regions);
  estimate.matches = matchInStages(base, functions, estimate.regions, samples);
  if (estimate.matches.empty()) {
    estimate.message = "no vertices of one side could be matched with the other side";
    return estimate;
  }
  BaseVertices last_base(*metric); // the last stage's matches and the extreme points
  last_base.addPairs(estimate.matches);
  estimate.confidence = distortionConfidence(isometricDistortion(last_base, estimate.matches, estimate.diameter)) *
                        pairsConfidence(pairs->cost);
  last_base.addPairs(limbs);
  estimate.side_function =
      absorbSpecks(surface.graph, sideFunction(last_base.sourceFields(), last_base.targetFields()));

  if (!parameters.sparse_only) {
    timer.start("dense", 0.7);
    matchEveryVertex(surface, last_base, estimate);
  }
  timer.stop();
  judge(estimate);
  return estimate;
}

} // namespace symmetry
} // namespace pcl
