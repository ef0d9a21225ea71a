/** \file
 * \brief Some consecutive entries of a list of indices.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Entries [first, last) of a list that outlives the range, as those of one row of several that are stored one
 * after the other. */
struct IndexRange {
  const Index* first = nullptr;
  const Index* last = nullptr;

  const Index*
  begin() const
  {
    return first;
  }

  const Index*
  end() const
  {
    return last;
  }

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(last - first);
  }

  bool
  empty() const
  {
    return first == last;
  }

  Index
  operator[](std::size_t i) const
  {
    return first[i];
  }
};

} // namespace symmetry
} // namespace pcl
