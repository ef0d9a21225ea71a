/** \file
 * \brief Going over to other numbers of points, as of a selection of them, and back.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Consecutive numbers for the points to keep, no_index for all others. */
inline std::vector<Index>
numbersOfKept(const std::vector<char>& keep)
{
  std::vector<Index> numbers(keep.size(), no_index);
  Index kept = 0;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v] != 0) {
      numbers[v] = kept++;
    }
  }
  return numbers;
}

/** \brief The points to keep, ascending. */
inline std::vector<Index>
keptPoints(const std::vector<char>& keep)
{
  std::vector<Index> kept;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v] != 0) {
      kept.push_back(static_cast<Index>(v));
    }
  }
  return kept;
}

/** \brief Replaces every index by its entry in \a numbers; no_index stays. */
inline void
renumber(std::vector<Index>& indices, const std::vector<Index>& numbers)
{
  for (Index& v : indices) {
    v = v == no_index ? no_index : numbers[v];
  }
}

/** \brief renumber () on a copy. */
inline std::vector<Index>
renumbered(std::vector<Index> indices, const std::vector<Index>& numbers)
{
  renumber(indices, numbers);
  return indices;
}

/** \brief Gives the corners of triangles other numbers; triangles with a corner that gets none are dropped. */
inline void
renumberTriangles(std::vector<Triangle>& triangles, const std::vector<Index>& numbers)
{
  std::size_t kept = 0;
  for (const Triangle& t : triangles) {
    const Triangle renumbered{numbers[t[0]], numbers[t[1]], numbers[t[2]]};
    if (renumbered[0] != no_index && renumbered[1] != no_index && renumbered[2] != no_index) {
      triangles[kept++] = renumbered;
    }
  }
  triangles.resize(kept);
}

/** \brief Turns a triangle so that it begins with its lowest corner: what is the same triangle becomes equal. */
inline Triangle
lowestFirst(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/** \brief Restricts a list to some of its entries. \param[in] kept their numbers, ascending */
template <typename Value>
void
keepEntries(std::vector<Value>& values, const std::vector<Index>& kept)
{
  for (std::size_t i = 0; i < kept.size(); ++i) { // ascending: nothing is overwritten that is still needed
    values[i] = values[kept[i]];
  }
  values.resize(kept.size());
}

/** \brief Makes a list with one entry per place one of \a size entries, with \a none where nothing has its place. */
template <typename Value>
void
scatter(std::vector<Value>& values, const std::vector<Index>& places, std::size_t size, Value none)
{
  std::vector<Value> scattered(size, none);
  for (std::size_t i = 0; i < places.size(); ++i) {
    scattered[places[i]] = values[i];
  }
  values = std::move(scattered);
}

} // namespace symmetry
} // namespace pcl
