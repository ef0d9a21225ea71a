#include "symmetry/hub_regions.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Positive where most ordered pairs have their source end nearer. */
float
sideOfHub(const HubSurface& hubs, const OrderedPairs& pairs, Index hub)
{
  float vote = 0.0F;
  for (std::size_t k = 0; k < pairs.sources.size(); ++k) {
    vote += hubs.distances(hub, pairs.targets[k]) - hubs.distances(hub, pairs.sources[k]);
  }
  return vote;
}

} // namespace

std::vector<std::pair<Index, Index>>
swappedExtremities(const HubSurface& hubs, const SampleMap& map, const OrderedPairs& pairs)
{
  constexpr float apart = 0.15F; // of the diameter: nearer ends belong to one limb, or to none
  std::vector<std::pair<Index, Index>> limbs;
  for (const Index extremity : hubs.extremities) {
    const Index partner = map[extremity];
    const bool known = std::any_of(limbs.begin(), limbs.end(), [&](const std::pair<Index, Index>& limb) {
      return std::min(hubs.distances(extremity, limb.first), hubs.distances(extremity, limb.second)) <
             apart * hubs.diameter;
    });
    if (!known && hubs.distances(extremity, partner) >= apart * hubs.diameter) {
      limbs.emplace_back(extremity, partner);
      if (sideOfHub(hubs, pairs, extremity) < 0.0F) {
        std::swap(limbs.back().first, limbs.back().second);
      }
    }
  }
  std::stable_sort(limbs.begin(), limbs.end(), [&](const auto& a, const auto& b) {
    return hubs.distances(a.first, a.second) > hubs.distances(b.first, b.second);
  });
  limbs.resize(std::min<std::size_t>(limbs.size(), 2));
  return limbs;
}

std::vector<Region>
hubRegions(const HubSurface& hubs, const std::vector<std::pair<Index, Index>>& limbs)
{
  constexpr std::array<std::array<Region, 2>, 2> names{
      {{Region::Source1, Region::Target1}, {Region::Source2, Region::Target2}}};
  std::vector<Region> regions(hubs.size(), Region::Centre);
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    float nearest = 1.0F;
    for (std::size_t k = 0; k < limbs.size(); ++k) {
      const float half_way = 0.5F * hubs.distances(limbs[k].first, limbs[k].second);
      const std::array<Index, 2> ends{limbs[k].first, limbs[k].second};
      for (std::size_t side = 0; side < 2; ++side) {
        const float relative = hubs.distances(row, ends[side]) / half_way;
        if (relative < nearest) {
          nearest = relative;
          regions[i] = names[k][side];
        }
      }
    }
  }
  return regions;
}

} // namespace symmetry
} // namespace pcl
