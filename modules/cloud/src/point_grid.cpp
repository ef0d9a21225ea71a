#include "cloud/point_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace symmetry {

PointGrid::PointGrid(const std::vector<Vector3>& points, float cell) : inverse_cell_(1.0F / cell)
{
  std::vector<Key> unsorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    unsorted[i] = key(cube(points[i]));
  }
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(),
            [&](Index a, Index b) { return unsorted[a] != unsorted[b] ? unsorted[a] < unsorted[b] : a < b; });
  keys_.reserve(points.size());
  for (const Index i : order_) {
    keys_.push_back(unsorted[i]);
  }
}

std::array<std::int64_t, 3>
PointGrid::cube(const Vector3& p) const
{
  std::array<std::int64_t, 3> c{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = static_cast<std::int64_t>(std::floor(p[k] * inverse_cell_));
  }
  return c;
}

PointGrid::Key
PointGrid::key(const std::array<std::int64_t, 3>& c)
{
  constexpr std::int64_t offset = std::int64_t{1} << 20; // 21 bits for each direction
  return static_cast<Key>(c[2] + offset) << 42U | static_cast<Key>(c[1] + offset) << 21U |
         static_cast<Key>(c[0] + offset);
}

std::array<std::size_t, 2>
PointGrid::row(const std::array<std::int64_t, 3>& first) const
{
  const auto begin = std::lower_bound(keys_.begin(), keys_.end(), key(first));
  const auto end = std::upper_bound(begin, keys_.end(), key({first[0] + 2, first[1], first[2]}));
  return {static_cast<std::size_t>(begin - keys_.begin()), static_cast<std::size_t>(end - keys_.begin())};
}

} // namespace symmetry
} // namespace pcl
