#include "symmetry/surface/open_sides.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {

std::vector<OpenSide>
openSides(std::size_t n, const std::vector<Triangle>& triangles)
{
  // Sides grouped by their lower end: few are in a group, so that the equal ones are soon found.
  std::vector<std::size_t> offsets(n + 1, 0);
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++offsets[static_cast<std::size_t>(std::min(t[k], t[(k + 1) % 3])) + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  struct HalfSide {
    Index higher;
    Index triangle;
    Index corner;
  };
  std::vector<HalfSide> halves(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const Index a = triangles[i][static_cast<std::size_t>(k)];
      const Index b = triangles[i][static_cast<std::size_t>((k + 1) % 3)];
      halves[next[std::min(a, b)]++] = {std::max(a, b), static_cast<Index>(i), k};
    }
  }
  std::vector<OpenSide> sides;
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = halves.begin() + static_cast<std::ptrdiff_t>(offsets[v]);
    const auto end = halves.begin() + static_cast<std::ptrdiff_t>(offsets[v + 1]);
    std::sort(begin, end, [](const HalfSide& x, const HalfSide& y) {
      return x.higher != y.higher ? x.higher < y.higher : x.triangle < y.triangle;
    });
    for (auto it = begin; it != end; ++it) {
      const bool is_repeated =
          (it != begin && (it - 1)->higher == it->higher) || (it + 1 != end && (it + 1)->higher == it->higher);
      if (!is_repeated) {
        const Triangle& t = triangles[it->triangle];
        const auto k = static_cast<std::size_t>(it->corner);
        sides.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3], it->triangle});
      }
    }
  }
  return sides;
}

OpenPoints::OpenPoints(std::size_t n, const std::vector<Triangle>& triangles, const std::vector<OpenSide>& sides)
    : triangles_(triangles)
{
  for (const OpenSide& side : sides) {
    points_.insert(points_.end(), {side.a, side.b});
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  std::vector<Index> place(n, no_index);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    place[points_[i]] = static_cast<Index>(i);
  }
  offsets_.assign(points_.size() + 1, 0);
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (place[v] != no_index) {
        ++offsets_[static_cast<std::size_t>(place[v]) + 1];
      }
    }
  }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  around_.resize(offsets_.back());
  std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Index v : triangles[i]) {
      if (place[v] != no_index) {
        around_[next[place[v]]++] = static_cast<Index>(i);
      }
    }
  }
}

} // namespace symmetry
} // namespace pcl
