#include "symmetry/confidence/support.h"

#include "base/statistics.h"
#include "base/union_find.h"
#include "symmetry/confidence/local_change.h"
#include "symmetry/search/map_score.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** Landmarks that share a triangle, both ways. */
std::vector<std::vector<Index>>
adjacentLandmarks(const LandmarkSurface& landmarks)
{
  std::vector<std::vector<Index>> adjacent(landmarks.size());
  for (const Triangle& t : landmarks.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      adjacent[t[k]].push_back(t[(k + 1) % 3]);
      adjacent[t[k]].push_back(t[(k + 2) % 3]);
    }
  }
  for (std::vector<Index>& around : adjacent) {
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }
  return adjacent;
}

/** Area of the samples nearest to each landmark; they sum up to 1. */
std::vector<float>
landmarkAreas(const SampledSurface& sampled)
{
  std::vector<float> areas(sampled.landmarks.size(), 0.0F);
  for (std::size_t i = 0; i < sampled.coarse.size(); ++i) {
    areas[sampled.landmarks.nearest_landmark[i]] += sampled.coarse.areas[i];
  }
  return areas;
}

float
markedArea(const std::vector<char>& marks, const std::vector<float>& areas)
{
  float area = 0.0F;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    area += marks[i] != 0 ? areas[i] : 0.0F;
  }
  return area;
}

/** The median of every landmark and those adjacent: one landmark that is off is noise. */
std::vector<float>
medianAround(const std::vector<std::vector<Index>>& adjacent, const std::vector<float>& values)
{
  std::vector<float> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<float> around{values[i]};
    for (const Index j : adjacent[i]) {
      around.push_back(values[j]);
    }
    result[i] = median(std::move(around));
  }
  return result;
}

/** Connected groups of the landmarks with a mark: for each landmark a member that stands for its group, no_index
 * without a mark; and the area of the group of each of these. */
struct Groups {
  std::vector<Index> of;
  std::vector<float> areas;
};

Groups
groupsOf(const std::vector<std::vector<Index>>& adjacent,
         const std::vector<float>& areas,
         const std::vector<char>& marks,
         char mark)
{
  UnionFind joined(marks.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for (const Index j : adjacent[i]) {
      if (marks[i] == mark && marks[j] == mark) {
        joined.join(static_cast<Index>(i), j);
      }
    }
  }
  Groups groups{std::vector<Index>(marks.size(), no_index), std::vector<float>(marks.size(), 0.0F)};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] == mark) {
      groups.of[i] = joined.find(static_cast<Index>(i));
      groups.areas[groups.of[i]] += areas[i];
    }
  }
  return groups;
}

/** Takes the mark off connected groups of less than this area. */
void
dropSmallGroups(const std::vector<std::vector<Index>>& adjacent,
                const std::vector<float>& areas,
                float least_area,
                std::vector<char>& marks)
{
  const Groups groups = groupsOf(adjacent, areas, marks, 1);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    marks[i] = static_cast<char>(groups.of[i] != no_index && groups.areas[groups.of[i]] >= least_area);
  }
}

/** Mean distance of a landmark from the nearest other one. */
float
spacingOf(const LandmarkSurface& landmarks)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < landmarks.distances.cols(); ++i) {
    float nearest = landmarks.diameter;
    for (Eigen::Index j = 0; j < landmarks.distances.rows(); ++j) {
      nearest = i == j ? nearest : std::min(nearest, landmarks.distances(j, i));
    }
    sum += static_cast<double>(nearest);
  }
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(1, landmarks.size())));
}

/** Distance from every landmark to the nearest one that holds the condition; infinite where none does. */
template <typename Condition>
std::vector<float>
distancesToNearest(const LandmarkSurface& landmarks, Condition condition)
{
  std::vector<float> nearest(landmarks.size(), std::numeric_limits<float>::infinity());
  for (std::size_t j = 0; j < nearest.size(); ++j) {
    for (std::size_t i = 0; condition(j) && i < nearest.size(); ++i) {
      nearest[i] =
          std::min(nearest[i], landmarks.distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
  return nearest;
}

/** Marks what lies around groups that stand out. */
void
disturbRims(const LandmarkSurface& landmarks,
            const Groups& groups,
            const SupportSettings& settings,
            std::vector<char>& is_disturbed)
{
  const float spacing = spacingOf(landmarks);
  const std::vector<float> depths =
      distancesToNearest(landmarks, [&](std::size_t i) { return groups.of[i] == no_index; });
  std::vector<float> extents(landmarks.size(), 0.0F);
  std::vector<float> counts(landmarks.size(), 0.0F);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (groups.of[i] != no_index) {
      extents[groups.of[i]] = std::max(extents[groups.of[i]], depths[i]);
      counts[groups.of[i]] += 1.0F;
    }
  }
  const std::vector<float> to_outstanding = distancesToNearest(landmarks, [&](std::size_t i) {
    const Index group = groups.of[i];
    return group != no_index && extents[group] > settings.outstanding * spacing * std::sqrt(counts[group]);
  });
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    is_disturbed[i] = static_cast<char>(is_disturbed[i] != 0 || to_outstanding[i] < settings.rim * landmarks.diameter);
  }
}

/** Those with a mark that the map exchanges with another place. */
std::vector<Index>
exchangedOf(const std::vector<char>& marks, const LandmarkSurface& landmarks, const SampleMap& map)
{
  std::vector<Index> exchanged;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0 && isExchanged(landmarks, map, static_cast<Index>(i), limb_separation)) {
      exchanged.push_back(static_cast<Index>(i));
    }
  }
  return exchanged;
}

/** Marks the images of what has a mark, what has its image there, and what is adjacent to these images. */
void
markImages(const std::vector<std::vector<Index>>& adjacent, const SampleMap& map, std::vector<char>& marks)
{
  const std::vector<char> before = marks;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (before[i] != 0) {
      marks[map[i]] = 1;
      for (const Index j : adjacent[map[i]]) {
        marks[j] = 1;
      }
    }
    marks[i] = static_cast<char>(marks[i] != 0 || before[map[i]] != 0);
  }
}

/** Marks the groups, apart from the largest, that the map mostly sends into themselves or to what has a mark. */
void
markCutOff(const Groups& rest, const std::vector<float>& areas, const SampleMap& map, std::vector<char>& marks)
{
  if (std::none_of(marks.begin(), marks.end(), [](char mark) { return mark != 0; })) {
    return;
  }
  const auto bulk = static_cast<Index>(std::max_element(rest.areas.begin(), rest.areas.end()) - rest.areas.begin());
  std::vector<float> kept(map.size(), 0.0F);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Index group = rest.of[i];
    if (group != no_index && (rest.of[map[i]] == group || rest.of[map[i]] == no_index)) {
      kept[group] += areas[i];
    }
  }
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Index group = rest.of[i];
    if (group != no_index && group != bulk && 2.0F * kept[group] > rest.areas[group]) {
      marks[i] = 1;
    }
  }
}

} // namespace

Support
findSupport(const SampledSurface& sampled,
            const SampleEstimate& samples,
            const std::vector<float>& local_change,
            const SupportSettings& settings)
{
  const std::vector<std::vector<Index>> adjacent = adjacentLandmarks(sampled.landmarks);
  const std::vector<float> areas = landmarkAreas(sampled);
  const std::vector<float> change = medianAround(adjacent, local_change);

  Support support;
  std::vector<char>& marks = support.is_unsupported;
  marks.resize(change.size());
  std::transform(change.begin(), change.end(), marks.begin(),
                 [&](float c) { return static_cast<char>(c > settings.change); });
  dropSmallGroups(adjacent, areas, settings.least_area, marks);
  if (settings.suspects_images) {
    markImages(adjacent, samples.landmark_map, marks);
  }
  markCutOff(groupsOf(adjacent, areas, marks, 0), areas, samples.landmark_map, marks);
  support.unsupported_share = markedArea(marks, areas);
  support.is_disturbed = marks;
  return support;
}

Support
takeBackSupported(const SampledSurface& sampled,
                  const SampleEstimate& samples,
                  const Support& support,
                  const SupportSettings& settings,
                  std::vector<float>& changes)
{
  Support result = support;
  std::vector<char>& marks = result.is_unsupported;
  const std::vector<std::vector<Index>> adjacent = adjacentLandmarks(sampled.landmarks);
  const LocalDistanceChange change(sampled, samples.partners);
  std::vector<Index> joining = exchangedOf(marks, sampled.landmarks, samples.landmark_map);
  for (const Index i : joining) {
    marks[i] = 0;
  }
  for (const Index i : joining) {
    changes[i] = std::min(changes[i], change.relativeTo(i, marks));
  }
  do {
    joining.clear();
    std::vector<float> relative(marks.size(), 0.0F); // of the landmarks without a mark not asked for
    for (std::size_t i = 0; i < marks.size(); ++i) {
      relative[i] = marks[i] != 0 ? change.relativeTo(static_cast<Index>(i), marks) : 0.0F;
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const bool is_at_rim =
          marks[i] != 0 && std::any_of(adjacent[i].begin(), adjacent[i].end(), [&](Index j) { return marks[j] == 0; });
      if (is_at_rim && std::max(relative[i], relative[samples.landmark_map[i]]) <= settings.change) {
        joining.push_back(static_cast<Index>(i));
        changes[i] = relative[i];
      }
    }
    for (const Index i : joining) {
      marks[i] = 0;
    }
  } while (!joining.empty());
  const std::vector<float> areas = landmarkAreas(sampled);
  dropSmallGroups(adjacent, areas, settings.least_area, marks);
  markCutOff(groupsOf(adjacent, areas, marks, 0), areas, samples.landmark_map, marks); // what lies beyond what is left
  result.unsupported_share = markedArea(marks, areas);
  disturbRims(sampled.landmarks, groupsOf(adjacent, areas, marks, 1), settings, result.is_disturbed);
  return result;
}

} // namespace symmetry
} // namespace pcl
