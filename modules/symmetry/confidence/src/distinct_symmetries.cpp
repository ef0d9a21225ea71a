#include "symmetry/confidence/distinct_symmetries.h"

#include "symmetry/confidence/map_asymmetry.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/search/map_regrowth.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Share of the landmarks around which a map rather keeps the orientation. */
float
keptShare(const LandmarkSurface& landmarks, const SampleMap& map)
{
  const std::vector<float> reversal = reversalAtLandmarks(landmarks, map);
  const auto kept = std::count_if(reversal.begin(), reversal.end(), [](float r) { return r < 0.0F; });
  return static_cast<float>(kept) / static_cast<float>(reversal.size());
}

/** On thin parts noise alone turns over a tenth of the triangles; a map that swaps the faces of a plate, but turns what
 * stands on it, leaves a fifth and more as it is. */
bool
reversesEverywhere(const LandmarkSurface& landmarks, const SampleMap& map)
{
  constexpr float most_kept = 0.15F;
  return keptShare(landmarks, map) <= most_kept;
}

bool
hasAxis(const MapScore& score)
{
  return score.nearest_image <= axis_reach;
}

SampleMap
composition(const SampleMap& first, const SampleMap& second)
{
  SampleMap map(first.size());
  std::transform(first.begin(), first.end(), map.begin(), [&](Index image) { return second[image]; });
  return map;
}

std::vector<DistinctReflection>
selectReflections(const LandmarkSurface& landmarks,
                  const ShapeDescriptor& descriptor,
                  const std::vector<SymmetryCandidate>& candidates,
                  std::size_t most)
{
  constexpr float least_relative_confidence = 0.9F; // of the best one's: as good as it; by hand
  std::vector<DistinctReflection> reflections;
  for (const SymmetryCandidate& candidate : candidates) {
    const bool is_result = reflections.empty();
    if (!is_result &&
        !(isReflection(candidate.score) && hasAxis(candidate.score) && reversesEverywhere(landmarks, candidate.map))) {
      continue;
    }
    const float confidence =
        candidateConfidence(candidate.score, findAsymmetry(landmarks, descriptor.curvature, candidate.map));
    if (is_result || confidence >= least_relative_confidence * reflections.front().confidence) {
      reflections.push_back({candidate, confidence});
    }
    if (reflections.size() == most) {
      break;
    }
  }
  return reflections;
}

/** Rotations that are distinct from each other and from the identity, of those that are good enough. */
std::vector<DistinctRotation>
keepDistinct(std::vector<DistinctRotation> rotations,
             const LandmarkSurface& landmarks,
             float distinct,
             std::size_t most)
{
  std::stable_sort(rotations.begin(), rotations.end(),
                   [](const DistinctRotation& a, const DistinctRotation& b) { return a.score.value < b.score.value; });
  std::vector<DistinctRotation> kept;
  for (DistinctRotation& rotation : rotations) {
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const DistinctRotation& other) {
      return mapDifference(landmarks, rotation.map, other.map) >= distinct;
    });
    if (is_new && rotation.score.displacement >= distinct && isRotation(rotation.score) && kept.size() < most) {
      kept.push_back(std::move(rotation));
    }
  }
  return kept;
}

} // namespace

DistinctSymmetries
distinctSymmetries(const LandmarkSurface& landmarks,
                   const ShapeDescriptor& descriptor,
                   const std::vector<SymmetryCandidate>& candidates,
                   const SearchSettings& settings,
                   std::size_t most)
{
  DistinctSymmetries result;
  result.reflections = selectReflections(landmarks, descriptor, candidates, most);
  std::vector<DistinctRotation> rotations;
  for (std::size_t a = 0; a < result.reflections.size(); ++a) {
    for (std::size_t b = 0; b < result.reflections.size(); ++b) {
      if (a != b) {
        const SampleMap& first = result.reflections[a].candidate.map;
        const SampleMap& second = result.reflections[b].candidate.map;
        DistinctRotation rotation{a, b, composition(first, second), {}, 0.0F};
        rotation.score = scoreRotation(landmarks, descriptor, rotation.map, composition(second, first), settings.score);
        rotation.confidence = scoreConfidence(rotation.score);
        rotations.push_back(std::move(rotation));
      }
    }
  }
  result.rotations = keepDistinct(std::move(rotations), landmarks, settings.distinct, most);
  return result;
}

} // namespace symmetry
} // namespace pcl
