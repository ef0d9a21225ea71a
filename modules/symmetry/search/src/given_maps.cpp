#include "symmetry/search/given_maps.h"

#include "base/parallel.h"
#include "symmetry/search/functional_map.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Empty where the map is known of no landmark. */
SampleMap
landmarkMapOf(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  const LandmarkSurface& landmarks = sampled.landmarks;
  SampleMap map;
  std::vector<Index> known;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Index partner = partners[sampled.coarse.cells.vertices[i]];
    map.push_back(partner == no_index ? no_index : landmarks.nearest_landmark[sampled.coarse.cells.owner[partner]]);
    if (partner != no_index) {
      known.push_back(static_cast<Index>(i));
    }
  }
  if (known.empty()) {
    return {};
  }
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i] == no_index) {
      const auto column = landmarks.distances.col(static_cast<Eigen::Index>(i));
      map[i] =
          map[*std::min_element(known.begin(), known.end(), [&](Index a, Index b) { return column[a] < column[b]; })];
    }
  }
  return map;
}

} // namespace

std::vector<SymmetryCandidate>
candidatesFromMaps(const SampledSurface& sampled, std::vector<SampleMap> maps, const SearchSettings& settings)
{
  if (maps.empty() || !sampled.isSearchable()) {
    return {};
  }
  std::vector<SymmetryCandidate> candidates(maps.size());
  const LandmarkSurface& landmarks = sampled.landmarks;
  const ShapeDescriptor guide =
      describeShape(sampled.coarse, sampled.basis, settings.guide.oriented_dimensions, settings.guide);
  const UpwardRefinement refinement(sampled.basis.functions, guide, static_cast<Eigen::Index>(landmarks.size()),
                                    {settings.levels.back()}, settings.guidance);
  parallelFor(candidates.size(), [&](std::size_t i) {
    SymmetryCandidate& candidate = candidates[i];
    candidate.map = std::move(maps[i]);
    candidate.matrix = refinement.refine(candidate.map);
    candidate.score = scoreMap(landmarks, sampled.descriptor, candidate.map, settings.coarse_targets, settings.score);
  });
  return candidates;
}

std::vector<SampleMap>
landmarkMapsOf(const SampledSurface& sampled, const std::vector<std::vector<Index>>& maps)
{
  std::vector<SampleMap> result;
  for (const std::vector<Index>& partners : maps) {
    SampleMap map = landmarkMapOf(sampled, partners);
    if (!map.empty()) {
      result.push_back(std::move(map));
    }
  }
  return result;
}

} // namespace symmetry
} // namespace pcl
