#include "cloud/point_grid.h"

#include "base/heartbeat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::int64_t offset = std::int64_t{1} << 20; // 21 bits for each direction

/** The edge of a cube, or the least with which all numbers of cubes have 20 bits. */
float
cellForAll(const std::vector<Vector3>& points, float cell)
{
  float largest = 0.0F;
  for (const Vector3& p : points) {
    for (const float x : p) {
      largest = std::max(largest, std::abs(x));
    }
  }
  const float least = 2.0F * largest / static_cast<float>(offset);
  return cell > least ? cell : std::max(least, std::numeric_limits<float>::min());
}

} // namespace

PointGrid::PointGrid(const std::vector<Vector3>& points, float cell) : inverse_cell_(1.0F / cellForAll(points, cell))
{
  std::vector<std::pair<Key, Index>> entries;
  entries.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<std::int64_t, 3> c = cube(points[i]);
    entries.emplace_back(rowKey(c) << 21U | static_cast<Key>(c[0] + offset), static_cast<Index>(i));
  }
  std::sort(entries.begin(), entries.end());
  xs_.reserve(entries.size());
  order_.reserve(entries.size());
  std::vector<Row> rows;
  for (const auto& [key, point] : entries) {
    const Key row = key >> 21U;
    const auto entry = static_cast<std::uint32_t>(order_.size());
    if (rows.empty() || rows.back().key != row) {
      rows.push_back({row, entry, entry});
    }
    ++rows.back().end;
    xs_.push_back(static_cast<std::int32_t>(static_cast<std::int64_t>(key & ((Key{1} << 21U) - 1U)) - offset));
    order_.push_back(point);
  }
  listCubes(points);
  if (starts_.empty()) {
    hashRows(rows);
  }
}

/** Lists the cubes of the box around all points, where these are few enough. */
void
PointGrid::listCubes(const std::vector<Vector3>& points)
{
  constexpr std::int64_t most_cubes = std::int64_t{1} << 19; // two megabytes, which a cache may hold
  if (points.empty()) {
    return;
  }
  low_ = cube(points.front());
  std::array<std::int64_t, 3> high = low_;
  for (const Vector3& p : points) {
    const std::array<std::int64_t, 3> c = cube(p);
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = std::min(low_[k], c[k]);
      high[k] = std::max(high[k], c[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    size_[k] = high[k] - low_[k] + 1;
  }
  // A size has 21 bits at most, so that two of them multiplied do not overflow, nor the third where these are few.
  if (size_[0] * size_[1] > most_cubes || size_[0] * size_[1] * size_[2] > most_cubes) {
    return;
  }
  starts_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2] + 1), 0);
  for (const Vector3& p : points) {
    const std::array<std::int64_t, 3> c = cube(p);
    const std::int64_t number = ((c[2] - low_[2]) * size_[1] + c[1] - low_[1]) * size_[0] + c[0] - low_[0];
    ++starts_[static_cast<std::size_t>(number) + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
}

void
PointGrid::hashRows(const std::vector<Row>& rows)
{
  unsigned bits = 1;
  while ((std::size_t{1} << bits) < 2 * rows.size()) {
    ++bits;
  }
  shift_ = 64U - bits;
  rows_.resize(std::size_t{1} << bits);
  for (const Row& row : rows) {
    rows_[slot(row.key)] = row;
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
PointGrid::rowKey(const std::array<std::int64_t, 3>& c)
{
  return static_cast<Key>(c[2] + offset) << 21U | static_cast<Key>(c[1] + offset);
}

std::size_t
PointGrid::slot(Key key) const
{
  constexpr Key golden = 0x9E3779B97F4A7C15U; // Fibonacci hashing: 2^64 over the golden ratio
  std::size_t place = (key * golden) >> shift_;
  while (rows_[place].end != 0 && rows_[place].key != key) {
    place = (place + 1) & (rows_.size() - 1);
  }
  return place;
}

std::array<std::size_t, 2>
PointGrid::hashedRow(const std::array<std::int64_t, 3>& first, std::int64_t last_x) const
{
  const Row& row = rows_[slot(rowKey(first))];
  const auto begin = std::lower_bound(xs_.begin() + row.begin, xs_.begin() + row.end, first[0]);
  const auto end = std::upper_bound(begin, xs_.begin() + row.end, last_x);
  return {static_cast<std::size_t>(begin - xs_.begin()), static_cast<std::size_t>(end - xs_.begin())};
}

float
uncrowdedCell(const std::vector<Vector3>& points, float cell, std::size_t most)
{
  constexpr float step = 0.8F;   // halves the volume
  constexpr int most_steps = 20; // a hundredth of the edge; what is crowded still is so at one place
  for (int i = 0; i < most_steps; ++i) {
    const PointGrid grid(points, cell);
    std::size_t visited = 0;
    for (auto p = points.begin(); p != points.end() && visited <= most * points.size(); ++p) {
      heartbeat();
      grid.visitAround(*p, [&visited](Index) { ++visited; });
    }
    if (visited <= most * points.size()) {
      break;
    }
    cell *= step;
  }
  return cell;
}

} // namespace symmetry
} // namespace pcl
