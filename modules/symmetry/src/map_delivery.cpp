#include "symmetry/map_delivery.h"

#include "base/vector_math.h"
#include "symmetry/confidence/distinct_symmetries.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/sides/limb_regions.h"
#include "symmetry/sides/sample_sides.h"
#include "symmetry/sides/side_growth.h"

#include <algorithm>
#include <array>
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

/** Landmarks on the source side that move, at most so many, of limbs and centre in turn: limbs are small, and evenly
 * spaced landmarks would mostly lie on the trunk. In the landmarks' own order, those of each region evenly spaced. */
std::vector<Index>
matchedLandmarks(const SampledSurface& sampled, const SampleMap& map, const MapEstimate& estimate)
{
  constexpr std::size_t maximum_matches = 100; // as the last stage of the staged method has
  constexpr float minimum_distance = 0.05F;    // of the diameter: what moves less lies at the axis
  const LandmarkSurface& landmarks = sampled.landmarks;
  std::array<std::vector<Index>, 3> in_region; // of the two limbs and the rest
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Index point = sampled.coarse.cells.vertices[i];
    const float apart = landmarks.distances(static_cast<Eigen::Index>(i), landmarks.nearest_landmark[map[i]]);
    if (apart >= minimum_distance * landmarks.diameter && estimate.side_function[point] > 0.0F) {
      const Region region = estimate.regions[point];
      in_region[region == Region::Source1 ? 0 : region == Region::Source2 ? 1 : 2].push_back(static_cast<Index>(i));
    }
  }
  const std::size_t longest = std::max({in_region[0].size(), in_region[1].size(), in_region[2].size()});
  std::vector<Index> taken;
  for (std::size_t k = 0; k < longest; ++k) {
    for (const std::vector<Index>& of_region : in_region) {
      if (k < of_region.size() && taken.size() < maximum_matches) {
        taken.push_back(of_region[k]);
      }
    }
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

/** One match for each of these landmarks, with the landmark nearest to the middle of the way. */
std::vector<SymmetricMatch>
sparseMatches(const SampledSurface& sampled, const SampleEstimate& samples, const MapEstimate& estimate)
{
  const LandmarkSurface& landmarks = sampled.landmarks;
  const auto partner_of = [&](Index landmark) {
    return landmarks.nearest_landmark[samples.map[landmark]];
  };
  std::vector<SymmetricMatch> matches;
  for (const Index source : matchedLandmarks(sampled, samples.map, estimate)) {
    const Index target = partner_of(source);
    Eigen::Index middle = 0;
    (landmarks.distances.col(source).cwiseMax(landmarks.distances.col(target))).minCoeff(&middle);
    const float change =
        (landmarks.distances(source, target) - landmarks.distances(target, partner_of(target))) / landmarks.diameter;
    matches.push_back({sampled.coarse.cells.vertices[source], samples.partners[source],
                       sampled.coarse.cells.vertices[static_cast<std::size_t>(middle)], std::abs(change)});
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
  estimate.confidences = pointConfidences(sampled, estimate.landmark_evidence, estimate.confidence);
  describeLimbs(sampled, samples.landmark_map, estimate);
  estimate.matches = sparseMatches(sampled, samples, estimate);
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
  describeLimbs(sampled, samples.landmark_map, estimate);
  estimate.matches = sparseMatches(sampled, samples, estimate);
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
