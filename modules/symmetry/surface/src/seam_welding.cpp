#include "symmetry/surface/seam_welding.h"

#include "base/heartbeat.h"
#include "base/union_find.h"
#include "symmetry/surface/mesh_cleaning.h"
#include "symmetry/surface/open_corners.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t comparison_limit = 4096; // others per point: a bound for files made to have none

struct ClosePair {
  double apart;
  std::size_t i;
  std::size_t j;
};

/** Pairs of open points within the tolerance of both, the closest first. */
std::vector<ClosePair>
closePairs(const OpenCorners& corners)
{
  // Compared along a direction that no side of a model is perpendicular to: few points are level with each other.
  const auto height = [&](std::size_t i) {
    const Vector3& p = corners.place(i);
    return 0.3714 * double{p[0]} + 0.5571 * double{p[1]} + 0.7428 * double{p[2]};
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    order.emplace_back(height(i), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<ClosePair> pairs;
  for (std::size_t k = 0; k < order.size(); ++k) {
    heartbeat();
    const auto [level, i] = order[k];
    const double reach = corners.tolerance(i);
    for (std::size_t l = k + 1; l < std::min(order.size(), k + comparison_limit) && order[l].first <= level + reach;
         ++l) {
      const std::size_t j = order[l].second;
      const double apart = lengthBetween(corners.place(i), corners.place(j));
      if (apart <= std::min(reach, corners.tolerance(j))) {
        pairs.push_back({apart, std::min(i, j), std::max(i, j)});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const ClosePair& a, const ClosePair& b) {
    return std::tie(a.apart, a.i, a.j) < std::tie(b.apart, b.i, b.j);
  });
  return pairs;
}

} // namespace

std::size_t
weldSeams(PreparedSurface& surface, const std::vector<OpenSide>& sides)
{
  if (sides.empty()) {
    return 0;
  }
  const OpenCorners corners(surface, sides);
  heartbeat();
  UnionFind welded(corners.size());
  std::map<Index, std::vector<Index>> members; // of what was welded
  const auto members_of = [&](Index i) -> std::vector<Index>& {
    return members.try_emplace(i, std::vector<Index>{i}).first->second;
  };
  for (const ClosePair& pair : closePairs(corners)) {
    heartbeat();
    const Index a = welded.find(static_cast<Index>(pair.i));
    const Index b = welded.find(static_cast<Index>(pair.j));
    if (a == b) {
      continue;
    }
    std::vector<Index>& of_a = members_of(a);
    std::vector<Index>& of_b = members_of(b);
    const bool are_sheets = std::any_of(of_a.begin(), of_a.end(), [&](Index i) {
      return std::any_of(of_b.begin(), of_b.end(), [&](Index j) {
        return corners.lieOver(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      });
    });
    if (!are_sheets) {
      welded.join(a, b);
      std::vector<Index>& to = a < b ? of_a : of_b;
      const std::vector<Index>& from = a < b ? of_b : of_a;
      to.insert(to.end(), from.begin(), from.end());
    }
  }
  std::vector<Index> first(surface.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    first[corners.point(i)] = corners.point(static_cast<std::size_t>(welded.find(static_cast<Index>(i))));
  }
  return letStandForOthers(surface, first);
}

} // namespace symmetry
} // namespace pcl
