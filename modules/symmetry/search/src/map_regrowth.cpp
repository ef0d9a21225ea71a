#include "symmetry/search/map_regrowth.h"

#include "base/sort_unique.h"
#include "base/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t placement_neighbours = 24;
static_assert(placement_neighbours <= kept_nearest_landmarks);

/** The first few landmarks around one. */
class Around {
public:
  Around(const LandmarkSurface& landmarks, Index landmark, std::size_t count)
      : nearest_(landmarks.nearest[landmark]), count_(std::min(count, nearest_.size()))
  {
  }

  std::vector<Index>::const_iterator
  begin() const
  {
    return nearest_.begin();
  }

  std::vector<Index>::const_iterator
  end() const
  {
    return nearest_.begin() + static_cast<std::ptrdiff_t>(count_);
  }

private:
  const std::vector<Index>& nearest_;
  std::size_t count_;
};

/** Area of a triangle of landmarks, doubled, and how much of it the map turns over: all, or none (the negative). */
struct TurnedTriangle {
  float area;
  float reversed;
};

TurnedTriangle
turnTriangle(const LandmarkSurface& landmarks, const SampleMap& map, const Triangle& t)
{
  const Vector3& p = landmarks.points[t[0]];
  const float area = norm(cross(landmarks.points[t[1]] - p, landmarks.points[t[2]] - p));
  const Triangle image{map[t[0]], map[t[1]], map[t[2]]};
  const Vector3& q = landmarks.points[image[0]];
  const Vector3 facing = cross(landmarks.points[image[1]] - q, landmarks.points[image[2]] - q);
  const Vector3 normal =
      normalized(landmarks.normals[image[0]] + landmarks.normals[image[1]] + landmarks.normals[image[2]]);
  return {area, std::clamp(-dot(facing, normal), -area, area)};
}

/** Triangles that share a corner with the triangles at a landmark, ascending. */
std::vector<std::size_t>
trianglesWithinTwoSteps(const LandmarkSurface& landmarks,
                        const std::vector<std::vector<std::size_t>>& at_landmark,
                        std::size_t landmark)
{
  std::vector<Index> corners;
  for (const std::size_t t : at_landmark[landmark]) {
    corners.insert(corners.end(), landmarks.triangles[t].begin(), landmarks.triangles[t].end());
  }
  sortUnique(corners);
  std::vector<std::size_t> patch;
  for (const Index corner : corners) {
    patch.insert(patch.end(), at_landmark[corner].begin(), at_landmark[corner].end());
  }
  sortUnique(patch);
  return patch;
}

/** Landmarks to be placed anew: where the map clearly keeps the orientation, and the uncertain ones around. */
std::vector<bool>
unsoundLandmarks(const LandmarkSurface& landmarks, const std::vector<float>& reversal)
{
  // Reversal is -1 where the orientation is kept, 1 where it is turned over; both limits are chosen by hand.
  constexpr float kept = -0.2F;
  constexpr float uncertain = 0.3F;
  constexpr int rings = 2;            // as far as one wrong landmark spoils the reversal around it
  constexpr std::size_t adjacent = 6; // neighbours of a point of an even lattice
  std::vector<bool> unsound(reversal.size());
  for (std::size_t i = 0; i < reversal.size(); ++i) {
    unsound[i] = reversal[i] <= kept;
  }
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<bool> inner = unsound;
    for (std::size_t i = 0; i < reversal.size(); ++i) {
      const Around around(landmarks, static_cast<Index>(i), adjacent);
      if (reversal[i] < uncertain && std::any_of(around.begin(), around.end(), [&](Index j) { return inner[j]; })) {
        unsound[i] = true;
      }
    }
  }
  return unsound;
}

/** Places landmarks by their distances to those that have a place. */
class LocalPlacement {
public:
  LocalPlacement(const LandmarkSurface& landmarks, const std::vector<bool>& unsound, SampleMap map)
      : landmarks_(landmarks), map_(std::move(map)), placed_(map_.size())
  {
    constexpr std::size_t maximum_anchors = 24;
    for (std::size_t i = 0; i < map_.size(); ++i) {
      placed_[i] = !unsound[i];
      if (placed_[i] && anchors_.size() < maximum_anchors) {
        anchors_.push_back(static_cast<Index>(i));
      }
    }
  }

  /** Every landmark has a place. */
  LocalPlacement(const LandmarkSurface& landmarks, SampleMap map, std::size_t anchors)
      : landmarks_(landmarks), map_(std::move(map)), placed_(map_.size(), true)
  {
    anchors_.resize(std::min(anchors, map_.size()));
    std::iota(anchors_.begin(), anchors_.end(), 0);
  }

  SampleMap
  run()
  {
    std::vector<Index> order;
    for (Index next = mostEnclosed(); next != no_index; next = mostEnclosed()) {
      order.push_back(next);
      map_[next] = bestImage(next, imagesAround(next));
      placed_[next] = true;
    }
    // Those placed first did not know of the later ones yet.
    constexpr int rounds = 3;
    moveImages(order, rounds);
    return std::move(map_);
  }

  SampleMap
  refit(int rounds)
  {
    std::vector<Index> order(map_.size());
    std::iota(order.begin(), order.end(), 0);
    moveImages(order, rounds);
    return std::move(map_);
  }

private:
  Around
  placesAround(Index landmark) const
  {
    return {landmarks_, landmark, placement_neighbours};
  }

  void
  moveImages(const std::vector<Index>& order, int rounds)
  {
    for (int round = 0; round < rounds; ++round) {
      for (const Index landmark : order) {
        const Around around = placesAround(map_[landmark]);
        std::vector<Index> candidates{map_[landmark]};
        candidates.insert(candidates.end(), around.begin(), around.end());
        map_[landmark] = bestImage(landmark, candidates);
      }
    }
  }

  /** The landmark without a place that has the most placed neighbours; none where there are no neighbours. */
  Index
  mostEnclosed() const
  {
    Index best = no_index;
    std::ptrdiff_t largest = 0;
    for (std::size_t i = 0; i < map_.size(); ++i) {
      if (!placed_[i]) {
        const Around around = placesAround(static_cast<Index>(i));
        const std::ptrdiff_t count = std::count_if(around.begin(), around.end(), [&](Index j) { return placed_[j]; });
        if (count > largest) {
          largest = count;
          best = static_cast<Index>(i);
        }
      }
    }
    return best;
  }

  /** Images of the placed neighbours and the landmarks around them. */
  std::vector<Index>
  imagesAround(Index landmark) const
  {
    std::vector<Index> images;
    for (const Index j : placesAround(landmark)) {
      if (placed_[j]) {
        const Around around = placesAround(map_[j]);
        images.push_back(map_[j]);
        images.insert(images.end(), around.begin(), around.end());
      }
    }
    sortUnique(images);
    return images;
  }

  /** Squared change of the distance to another landmark, over that distance: near ones are the more reliable. */
  float
  changeOf(Index landmark, Index image, Index other) const
  {
    const float wanted = landmarks_.distances(landmark, other);
    const float change = wanted - landmarks_.distances(image, map_[other]);
    constexpr float finite = 1e-3F; // share of the diameter, far below the distance of two landmarks
    return change * change / (wanted + finite * landmarks_.diameter);
  }

  Index
  bestImage(Index landmark, const std::vector<Index>& candidates) const
  {
    Index best = map_[landmark];
    float least = std::numeric_limits<float>::infinity();
    for (const Index candidate : candidates) {
      float cost = 0.0F;
      for (const Index j : placesAround(landmark)) {
        cost += placed_[j] ? changeOf(landmark, candidate, j) : 0.0F;
      }
      for (const Index j : anchors_) {
        cost += j != landmark ? changeOf(landmark, candidate, j) : 0.0F;
      }
      if (cost < least) {
        least = cost;
        best = candidate;
      }
    }
    return best;
  }

  const LandmarkSurface& landmarks_;
  SampleMap map_;
  std::vector<bool> placed_;
  std::vector<Index> anchors_; ///< sound landmarks all over the surface
};

} // namespace

std::vector<float>
reversalAtLandmarks(const LandmarkSurface& landmarks, const SampleMap& map)
{
  std::vector<std::vector<std::size_t>> at_landmark(landmarks.size());
  std::vector<TurnedTriangle> turned;
  for (std::size_t t = 0; t < landmarks.triangles.size(); ++t) {
    turned.push_back(turnTriangle(landmarks, map, landmarks.triangles[t]));
    for (const Index corner : landmarks.triangles[t]) {
      at_landmark[corner].push_back(t);
    }
  }
  std::vector<float> reversal(landmarks.size(), 0.0F);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    float reversed = 0.0F;
    float area = 0.0F;
    for (const std::size_t t : trianglesWithinTwoSteps(landmarks, at_landmark, i)) {
      reversed += turned[t].reversed;
      area += turned[t].area;
    }
    reversal[i] = area > 0.0F ? reversed / area : 0.0F;
  }
  return reversal;
}

std::vector<float>
stretchAtLandmarks(const LandmarkSurface& landmarks, const SampleMap& map)
{
  std::vector<float> stretch(landmarks.size(), 0.0F);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    float change = 0.0F;
    float length = 0.0F;
    for (const Index j : landmarks.nearest[i]) {
      const float wanted = landmarks.distances(static_cast<Eigen::Index>(i), j);
      change += std::abs(wanted - landmarks.distances(map[i], map[j]));
      length += wanted;
    }
    stretch[i] = length > 0.0F ? change / length : 0.0F;
  }
  return stretch;
}

SampleMap
relaxedMap(const LandmarkSurface& landmarks, const SampleMap& map)
{
  const std::vector<float> stretch = stretchAtLandmarks(landmarks, map);
  std::vector<float> sorted = stretch;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  std::vector<bool> torn(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    torn[i] = stretch[i] > 2.0F * *middle;
  }
  return LocalPlacement(landmarks, torn, map).run();
}

SampleMap
refittedMap(const LandmarkSurface& landmarks, SampleMap map, int rounds)
{
  constexpr std::size_t anchors = 48;
  return LocalPlacement(landmarks, std::move(map), anchors).refit(rounds);
}

SampleMap
regrownMap(const LandmarkSurface& landmarks, const SampleMap& map)
{
  const std::vector<float> reversal = reversalAtLandmarks(landmarks, map);
  const std::vector<bool> unsound = unsoundLandmarks(landmarks, reversal);
  const auto count = static_cast<std::size_t>(std::count(unsound.begin(), unsound.end(), true));
  if (count == 0 || 2 * count > map.size()) {
    return {};
  }
  return LocalPlacement(landmarks, unsound, map).run();
}

} // namespace symmetry
} // namespace pcl
