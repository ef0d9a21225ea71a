/** \file
 * \brief Disjoint sets.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Disjoint sets of points, at first one for each; each is known by the lowest of its points. */
class UnionFind {
public:
  explicit UnionFind(std::size_t n) : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  Index
  find(Index v)
  {
    while (parent_[v] != v) {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }

  /** \brief True where a and b were in different sets. */
  bool
  join(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /** \brief The set with most points, of several the one with the lowest point; no_index if there are no points. */
  Index
  largest()
  {
    std::vector<std::size_t> sizes(parent_.size(), 0);
    for (std::size_t v = 0; v < parent_.size(); ++v) {
      ++sizes[find(static_cast<Index>(v))];
    }
    const auto found = std::max_element(sizes.begin(), sizes.end());
    return found == sizes.end() ? no_index : static_cast<Index>(found - sizes.begin());
  }

private:
  std::vector<Index> parent_;
};

} // namespace symmetry
} // namespace pcl
