#include "symmetry/map_repair.h"

#include "geodesic/vector_math.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <cstdio>
#include <cstdlib>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t neighbours_per_hub = 24;

/** The hubs nearest to each hub, nearest first, without itself. */
std::vector<std::vector<Index>>
nearestHubs(const HubSurface& hubs)
{
  const std::size_t count = std::min(neighbours_per_hub + 1, hubs.size());
  std::vector<std::vector<Index>> nearest(hubs.size());
  std::vector<Index> order(hubs.size());
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    std::iota(order.begin(), order.end(), 0);
    const auto column = hubs.distances.col(static_cast<Eigen::Index>(i));
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](Index a, Index b) {
                        return column(a) < column(b) || (column(a) == column(b) && a < b);
                      });
    for (std::size_t k = 0; k < count; ++k) {
      if (order[k] != static_cast<Index>(i)) {
        nearest[i].push_back(order[k]);
      }
    }
  }
  return nearest;
}

class LocalRepair {
public:
  LocalRepair(const HubSurface& hubs, const SampleMap& map) : hubs_(hubs), map_(map), near_(nearestHubs(hubs)) {}

  SampleMap
  run(const std::vector<bool>& sound)
  {
    placed_ = sound;
    static const std::size_t far = getenv("FAR") ? atoi(getenv("FAR")) : 24;
    for (std::size_t i = 0; i < sound.size() && far_.size() < far; ++i) {
      if (sound[i]) {
        far_.push_back(static_cast<Index>(i));
      }
    }
    std::vector<Index> order;
    for (Index next = nextHub(); next != no_index; next = nextHub()) {
      order.push_back(next);
      map_[next] = bestImage(next, imagesAround(next));
      placed_[next] = true;
    }
    for (int round = 0; round < 3; ++round) {
      for (const Index hub : order) {
        std::vector<Index> candidates = near_[map_[hub]];
        candidates.push_back(map_[hub]);
        map_[hub] = bestImage(hub, candidates);
      }
    }
    return map_;
  }

private:
  /** The hub with the most placed neighbours. */
  Index
  nextHub() const
  {
    Index best = no_index;
    std::size_t most = 0;
    for (std::size_t i = 0; i < map_.size(); ++i) {
      if (!placed_[i]) {
        const auto count = static_cast<std::size_t>(
            std::count_if(near_[i].begin(), near_[i].end(), [&](Index j) { return placed_[j]; }));
        if (count > most) {
          most = count;
          best = static_cast<Index>(i);
        }
      }
    }
    return best;
  }

  std::vector<Index>
  imagesAround(Index hub) const
  {
    std::vector<Index> images;
    for (const Index j : near_[hub]) {
      if (placed_[j]) {
        images.push_back(map_[j]);
        images.insert(images.end(), near_[map_[j]].begin(), near_[map_[j]].end());
      }
    }
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    return images;
  }

  Index
  bestImage(Index hub, const std::vector<Index>& candidates) const
  {
    Index best = map_[hub];
    float least = std::numeric_limits<float>::infinity();
    for (const Index candidate : candidates) {
      float cost = 0.0F;
      for (const Index j : near_[hub]) {
        if (placed_[j]) {
          const float wanted = hubs_.distances(hub, j);
          const float change = wanted - hubs_.distances(candidate, map_[j]);
          cost += change * change / wanted;
        }
      }
      for (const Index j : far_) {
        const float wanted = hubs_.distances(hub, j);
        const float change = wanted - hubs_.distances(candidate, map_[j]);
        cost += change * change / (wanted + 1e-3F * hubs_.diameter);
      }
      if (cost < least) {
        least = cost;
        best = candidate;
      }
    }
    return best;
  }

  const HubSurface& hubs_;
  SampleMap map_;
  std::vector<std::vector<Index>> near_;
  std::vector<bool> placed_;
  std::vector<Index> far_; ///< sound hubs all over the surface
};

} // namespace

std::vector<float>
reversalAtHubs(const HubSurface& hubs, const SampleMap& map)
{
  std::vector<float> reversed(hubs.size(), 0.0F);
  std::vector<float> total(hubs.size(), 0.0F);
  std::vector<std::vector<std::size_t>> at_hub(hubs.size());
  std::vector<float> turned(hubs.triangles.size());
  std::vector<float> areas(hubs.triangles.size());
  for (std::size_t k = 0; k < hubs.triangles.size(); ++k) {
    const Triangle& t = hubs.triangles[k];
    const Vector3& p = hubs.points[t[0]];
    const Vector3 facing0 = cross(hubs.points[t[1]] - p, hubs.points[t[2]] - p);
    const float area = norm(facing0);
    const Vector3& q = hubs.points[map[t[0]]];
    const Vector3 facing = cross(hubs.points[map[t[1]]] - q, hubs.points[map[t[2]]] - q);
    const Vector3 normal = normalized(hubs.normals[map[t[0]]] + hubs.normals[map[t[1]]] + hubs.normals[map[t[2]]]);
    turned[k] = std::clamp(-dot(facing, normal), -area, area);
    areas[k] = area;
    for (const Index v : t) {
      at_hub[v].push_back(k);
    }
  }
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    std::vector<std::size_t> patch;
    for (const std::size_t k : at_hub[i]) {
      for (const Index v : hubs.triangles[k]) {
        patch.insert(patch.end(), at_hub[v].begin(), at_hub[v].end());
      }
    }
    std::sort(patch.begin(), patch.end());
    patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
    for (const std::size_t k : patch) {
      reversed[i] += turned[k];
      total[i] += areas[k];
    }
    reversed[i] = total[i] > 0.0F ? reversed[i] / total[i] : 0.0F;
  }
  return reversed;
}

SampleMap
repairedMap(const HubSurface& hubs, const SampleMap& map)
{
  static const float core = static_cast<float>(getenv("LR") ? atof(getenv("LR")) : -0.2F);
  static const float rim = static_cast<float>(getenv("RIM") ? atof(getenv("RIM")) : 0.3F);
  static const int grow = getenv("GROW") ? atoi(getenv("GROW")) : 2;
  const std::vector<float> reversal = reversalAtHubs(hubs, map);
  const auto near = nearestHubs(hubs);
  std::vector<bool> sound(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    sound[i] = reversal[i] > core;
  }
  for (int g = 0; g < grow; ++g) {
    std::vector<bool> grown = sound;
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (sound[i] && reversal[i] < rim) {
        for (std::size_t k = 0; k < 6 && k < near[i].size(); ++k) {
          if (!sound[near[i][k]]) {
            grown[i] = false;
          }
        }
      }
    }
    sound = grown;
  }
  const auto count = static_cast<std::size_t>(std::count(sound.begin(), sound.end(), true));
  if (getenv("DBG")) {
    std::vector<int> h(11, 0);
    for (float r : reversal)
      h[static_cast<int>((r + 1) * 5)]++;
    fprintf(stderr, "sound %zu of %zu:", count, map.size());
    for (int x : h)
      fprintf(stderr, " %d", x);
    fprintf(stderr, "\n");
  }
  if (count == map.size() || 2 * count < map.size()) {
    return {};
  }
  return LocalRepair(hubs, map).run(sound);
}

} // namespace symmetry
} // namespace pcl
