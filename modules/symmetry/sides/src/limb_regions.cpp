#include "symmetry/sides/limb_regions.h"

#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace symmetry {
namespace {

constexpr LimbSettings settings{};

} // namespace

std::vector<std::pair<Index, Index>>
swappedExtremities(const LandmarkSurface& landmarks, const SampleMap& map, const std::vector<float>& sides)
{
  std::vector<std::pair<Index, Index>> limbs;
  for (const Index extremity : landmarks.extremities) {
    const Index partner = map[extremity];
    const bool known = std::any_of(limbs.begin(), limbs.end(), [&](const std::pair<Index, Index>& limb) {
      return std::min(landmarks.distances(extremity, limb.first), landmarks.distances(extremity, limb.second)) <
             settings.separation * landmarks.diameter;
    });
    if (!known && landmarks.distances(extremity, partner) >= settings.separation * landmarks.diameter) {
      limbs.emplace_back(extremity, partner);
      if (sides[extremity] < 0.0F) {
        std::swap(limbs.back().first, limbs.back().second);
      }
    }
  }
  std::stable_sort(limbs.begin(), limbs.end(), [&](const auto& a, const auto& b) {
    return landmarks.distances(a.first, a.second) > landmarks.distances(b.first, b.second);
  });
  limbs.resize(std::min<std::size_t>(limbs.size(), settings.pairs));
  return limbs;
}

std::vector<Region>
limbRegions(const LandmarkSurface& landmarks, const std::vector<std::pair<Index, Index>>& limbs)
{
  constexpr std::array<std::array<Region, 2>, 2> names{
      {{Region::Source1, Region::Target1}, {Region::Source2, Region::Target2}}};
  std::vector<Region> regions(landmarks.size(), Region::Centre);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    float nearest = 1.0F;
    for (std::size_t k = 0; k < limbs.size(); ++k) {
      const float half_way = 0.5F * landmarks.distances(limbs[k].first, limbs[k].second);
      const std::array<Index, 2> extremities{limbs[k].first, limbs[k].second};
      for (std::size_t side = 0; side < 2; ++side) {
        const float relative = landmarks.distances(row, extremities[side]) / half_way;
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
