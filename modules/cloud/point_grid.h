/** \file
 * \brief Points sorted into the cubes of a grid, for searches within a given distance.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Finds the points near a place in constant time where the points are evenly spread; holds numbers, not points.
 */
class PointGrid {
public:
  /** \param[in] points all finite, within a few units of the origin
   * \param[in] cell edge of a cube; taken for larger where a coordinate is more than half a million times as large */
  PointGrid(const std::vector<Vector3>& points, float cell);

  /** \brief Calls visit (i) for every point i in the 27 cubes around a place: all that are nearer than an edge, and
   * some more. In a fixed order. */
  template <typename Visit>
  void
  visitAround(const Vector3& place, Visit visit) const
  {
    visitRangesAround(place, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        visit(order_[i]);
      }
    });
  }

  /** \brief Calls visit (begin, end) for ranges of order () with those points: for callers that keep what they need of
   * the points in that order. */
  template <typename Visit>
  void
  visitRangesAround(const Vector3& place, Visit visit) const
  {
    const std::array<std::int64_t, 3> centre = cube(place);
    for (std::int64_t z = -1; z <= 1; ++z) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        const auto [begin, end] = row({centre[0] - 1, centre[1] + y, centre[2] + z}, centre[0] + 1);
        visit(begin, end);
      }
    }
  }

  /** \brief Calls visit (i) for the points around a place, those of the nearest cubes first, until all that are left are
   * farther than what the last call of visit () returned, at first \a reach. */
  template <typename Visit>
  void
  visitNearest(const Vector3& place, float reach, Visit visit) const
  {
    const std::array<std::int64_t, 3> centre = cube(place);
    for (std::int64_t ring = 0; ring <= 1 || static_cast<float>(ring - 1) <= reach * inverse_cell_; ++ring) {
      for (std::int64_t z = -ring; z <= ring; ++z) {
        for (std::int64_t y = -ring; y <= ring; ++y) {
          const bool is_side = std::max(std::abs(y), std::abs(z)) == ring;
          // Of a row that runs through the ring only its ends belong to it.
          for (std::int64_t x = -ring; x <= ring; x += is_side || ring == 0 ? 2 * ring + 1 : 2 * ring) {
            const auto [begin, end] =
                row({centre[0] + x, centre[1] + y, centre[2] + z}, centre[0] + (is_side ? ring : x));
            for (std::size_t i = begin; i < end; ++i) {
              reach = visit(order_[i]);
            }
          }
        }
      }
    }
  }

  /** \brief Calls visit (i) for every point i in the cubes that meet a box: all in the box, and some more. In a fixed
   * order. */
  template <typename Visit>
  void
  visitBox(const Vector3& low, const Vector3& high, Visit visit) const
  {
    anyInBox(low, high, [&visit](Index i) {
      visit(i);
      return false;
    });
  }

  /** \brief Whether found (i) is true of any point i in the cubes that meet a box. In a fixed order, and to the first. */
  template <typename Found>
  bool
  anyInBox(const Vector3& low, const Vector3& high, Found found) const
  {
    const std::array<std::int64_t, 3> first = cube(low);
    const std::array<std::int64_t, 3> last = cube(high);
    for (std::int64_t z = first[2]; z <= last[2]; ++z) {
      for (std::int64_t y = first[1]; y <= last[1]; ++y) {
        const auto [begin, end] = row({first[0], y, z}, last[0]);
        if (std::any_of(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                        order_.begin() + static_cast<std::ptrdiff_t>(end), found)) {
          return true;
        }
      }
    }
    return false;
  }

  /** \brief All points, in the order in which visits meet them. */
  const std::vector<Index>&
  order() const
  {
    return order_;
  }

private:
  using Key = std::uint64_t;

  /** The cubes with the same y and z that hold points. */
  struct Row {
    Key key = 0;
    std::uint32_t begin = 0; ///< first entry; both 0: no row
    std::uint32_t end = 0;
  };

  std::array<std::int64_t, 3>
  cube(const Vector3& p) const;

  static Key
  rowKey(const std::array<std::int64_t, 3>& c);

  /** The place of a row in the table, or where it would be entered. */
  std::size_t
  slot(Key key) const;

  /** Entries of the cubes from one to another along x. */
  std::array<std::size_t, 2>
  row(const std::array<std::int64_t, 3>& first, std::int64_t last_x) const
  {
    return starts_.empty() ? hashedRow(first, last_x) : listedRow(first, last_x);
  }

  std::array<std::size_t, 2>
  hashedRow(const std::array<std::int64_t, 3>& first, std::int64_t last_x) const;

  std::array<std::size_t, 2>
  listedRow(const std::array<std::int64_t, 3>& first, std::int64_t last_x) const
  {
    const std::int64_t x = std::max<std::int64_t>(first[0] - low_[0], 0);
    const std::int64_t end_x = std::min(last_x - low_[0] + 1, size_[0]);
    const std::int64_t y = first[1] - low_[1];
    const std::int64_t z = first[2] - low_[2];
    if (x >= end_x || y < 0 || y >= size_[1] || z < 0 || z >= size_[2]) {
      return {0, 0};
    }
    const std::uint32_t* starts = starts_.data() + (z * size_[1] + y) * size_[0];
    return {starts[x], starts[end_x]};
  }

  void
  listCubes(const std::vector<Vector3>& points);

  void
  hashRows(const std::vector<Row>& rows);

  float inverse_cell_;
  /** Where the cubes are few, the first entry of each one of the box around all, x fastest, and one more at the end; empty
   * where they are many. */
  std::vector<std::uint32_t> starts_;
  std::array<std::int64_t, 3> low_{};  ///< cube of the box
  std::array<std::int64_t, 3> size_{}; ///< of the box, in cubes
  std::vector<Row> rows_;              ///< where the cubes are many: hashed, at most half full
  unsigned shift_ = 0;                 ///< from a hash to a place among rows_
  std::vector<std::int32_t> xs_;       ///< of the cubes of the entries, ascending within a row
  std::vector<Index> order_;           ///< points of the entries, ascending within a cube
};

/** \brief The edge of cubes of which 27 hold at most \a most points on average: \a cell, or less where points are crowded.
 *
 * For searches among the samples of what should be a surface. Points that fill space or lie tangled are as near to each
 * other as ever, but have neighbours so far off that any number of points comes to lie within the distance of those. */
float
uncrowdedCell(const std::vector<Vector3>& points, float cell, std::size_t most);

} // namespace symmetry
} // namespace pcl
