#include "symmetry/map_delivery.h"

#include "base/vector_math.h"
#include "symmetry/confidence/distinct_symmetries.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/sides/limb_regions.h"
#include "symmetry/sides/sample_sides.h"
#include "symmetry/sides/side_growth.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl {
namespace symmetry {
namespace {

/** The sides of the samples, falling off towards the axis with the way to their partners: they can be
 * interpolated then, and one on the axis that leans to the wrong side does no harm. */
std::vector<float>
slopingSides(const SampledSurface& sampled, const std::vector<Index>& sample_partners)
{
  const float slope = 2.0F * sampleSpacing(sampled.coarse); // a way that samples resolve
  std::vector<float> sides = sampleSides(sampled, sample_partners);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const float way = distance(sampled.coarse.points[i], sampled.surface.points[sample_partners[i]]);
    sides[i] *= std::min(1.0F, way / slope);
  }
  return sides;
}

/** The sides of the samples carried over to the points, made antisymmetric under the map, grown to where it is weak. */
std::vector<float>
pointSides(const SampledSurface& sampled, const SampleEstimate& samples, const std::vector<Index>& partners)
{
  const std::vector<float> at_samples = slopingSides(sampled, samples.partners);
  std::vector<float> at_points(partners.size());
  for (std::size_t v = 0; v < partners.size(); ++v) {
    at_points[v] = sampled.interpolation.at(v, at_samples);
  }
  std::vector<float> sides(partners.size());
  std::vector<float> ways(partners.size());
  for (std::size_t v = 0; v < partners.size(); ++v) {
    sides[v] = 0.5F * (at_points[v] - at_points[partners[v]]);
    ways[v] = distance(sampled.surface.points[v], sampled.surface.points[partners[v]]);
  }
  return growSides(sampled.surface.graph, partners, ways, sides);
}

/** One match for every landmark on the source side that moves, with the landmark nearest to the middle of the way. */
std::vector<SymmetricMatch>
sparseMatches(const SampledSurface& sampled, const SampleEstimate& samples, const std::vector<float>& sides)
{
  constexpr std::size_t maximum_matches = 100; // as the last stage of the staged method has
  constexpr float minimum_distance = 0.05F;    // of the diameter: what moves less lies at the axis
  const SampleMap& map = samples.map;
  const LandmarkSurface& landmarks = sampled.landmarks;
  std::vector<SymmetricMatch> matches;
  for (std::size_t i = 0; i < landmarks.size() && matches.size() < maximum_matches; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Index partner = sampled.landmarks.nearest_landmark[map[i]];
    const Index point = sampled.coarse.cells.vertices[i];
    const float apart = landmarks.distances(row, partner);
    if (apart < minimum_distance * landmarks.diameter || sides[point] <= 0.0F) {
      continue;
    }
    Eigen::Index middle = 0;
    (landmarks.distances.col(row).cwiseMax(landmarks.distances.col(partner))).minCoeff(&middle);
    const float change = (landmarks.distances(partner, row) -
                          landmarks.distances(row, sampled.landmarks.nearest_landmark[map[partner]])) /
                         landmarks.diameter;
    matches.push_back({point, samples.partners[i], sampled.coarse.cells.vertices[static_cast<std::size_t>(middle)],
                       std::abs(change)});
  }
  return matches;
}

/** Region of every point and the extremities of the limbs; the sides are known. */
void
describeLimbs(const SampledSurface& sampled, const SampleMap& map, MapEstimate& estimate)
{
  std::vector<float> sides;
  for (std::size_t i = 0; i < map.size(); ++i) {
    sides.push_back(estimate.side_function[sampled.coarse.cells.vertices[i]]);
  }
  const auto limbs = swappedExtremities(sampled.landmarks, map, sides);
  const std::vector<Region> landmark_regions = limbRegions(sampled.landmarks, limbs);
  for (const Index cell : sampled.coarse.cells.owner) {
    estimate.regions.push_back(landmark_regions[sampled.landmarks.nearest_landmark[cell]]);
  }
  for (const auto& [source, target] : limbs) {
    estimate.extremities.push_back(sampled.coarse.cells.vertices[source]);
    estimate.extremities.push_back(sampled.coarse.cells.vertices[target]);
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

} // namespace

void
deliverMap(const SampledSurface& sampled, const SampleEstimate& samples, MapEstimate& estimate)
{
  estimate.partners = partnersOfPoints(sampled, samples.partners);
  estimate.side_function = pointSides(sampled, samples, estimate.partners);
  estimate.matches = sparseMatches(sampled, samples, estimate.side_function);
  estimate.confidences = pointConfidences(sampled, estimate.landmark_evidence, estimate.confidence);
  describeLimbs(sampled, samples.landmark_map, estimate);
}

void
describeMap(const SampledSurface& sampled, MapEstimate& estimate)
{
  SampleEstimate samples;
  const CoarseSurface& coarse = sampled.coarse;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const Index point = coarse.cells.vertices[i];
    const Index partner = estimate.partners[point] == no_index ? point : estimate.partners[point];
    samples.partners.push_back(partner);
    samples.map.push_back(coarse.cells.owner[partner]);
  }
  for (std::size_t i = 0; i < sampled.landmarks.size(); ++i) {
    samples.landmark_map.push_back(sampled.landmarks.nearest_landmark[samples.map[i]]);
  }
  estimate.matches = sparseMatches(sampled, samples, estimate.side_function);
  describeLimbs(sampled, samples.landmark_map, estimate);
}

void
deliverAlternatives(const SampledSurface& sampled,
                    const SampleRefinement& refinement,
                    const MapJudge& judge,
                    const Contender& taken,
                    const std::vector<SymmetryCandidate>& candidates,
                    const SearchSettings& settings,
                    std::size_t maximum,
                    MapEstimate& estimate)
{
  const DistinctSymmetries distinct = distinctSymmetries(sampled.landmarks, sampled.descriptor,
                                                         withFirst(*taken.candidate, candidates), settings, maximum);
  for (const DistinctReflection& reflection : distinct.reflections) {
    const SampleEstimate samples = refinement.refine(reflection.candidate);
    const float confidence = estimate.alternatives.empty()
                                 ? estimate.confidence // of the map itself
                                 : mapConfidence(judge.evidenceFor(reflection.candidate, samples));
    estimate.alternatives.push_back(
        {partnersOfPoints(sampled, samples.partners), reflection.candidate.score.value, confidence, true});
  }
  for (const DistinctRotation& rotation : distinct.rotations) {
    const std::vector<Index>& second = estimate.alternatives[rotation.second].partners;
    std::vector<Index> images = estimate.alternatives[rotation.first].partners;
    std::transform(images.begin(), images.end(), images.begin(), [&](Index image) { return second[image]; });
    estimate.rotations.push_back({std::move(images), rotation.score.value, rotation.confidence, false});
  }
}

} // namespace symmetry
} // namespace pcl
