/** \file
 * \brief Smallest vertex cover of a bipartite graph.
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The fewest vertices that touch every edge between two sets, found by a largest matching (D. Koenig: Grafok es
 * matrixok. Matematikai es Fizikai Lapok 38, 1931 \cite koenig1931grafok).
 *
 * One object for many pairs of sets, from one thread. Cost O(n m) at worst; between the sides of a cut through a
 * surface about O(m).
 */
class VertexCover {
public:
  /** \param[in] left
   *
   * \param[in] right numbers of vertices
   * \param[in] edges_of called as (l, use); calls use (r) for every right vertex r that is joined to left vertex l
   * \param[out] cover_left those of the left in the cover, rising
   * \param[out] cover_right those of the right */
  template <typename EdgesOf>
  void
  find(std::size_t left,
       std::size_t right,
       EdgesOf edges_of,
       std::vector<std::uint32_t>& cover_left,
       std::vector<std::uint32_t>& cover_right)
  {
    left_mate_.assign(left, none);
    right_mate_.assign(right, none);
    reached_from_.resize(right);
    seen_.assign(right, 0);
    for (std::uint32_t l = 0; l < left; ++l) {
      augment(l, edges_of);
    }
    // Of each matched pair one: the right vertex where a search that failed has reached it.
    cover_left.clear();
    cover_right.clear();
    for (std::uint32_t l = 0; l < left; ++l) {
      if (left_mate_[l] != none) {
        if (seen_[left_mate_[l]] == failed) {
          cover_right.push_back(left_mate_[l]);
        }
        else {
          cover_left.push_back(l);
        }
      }
    }
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t failed = none; ///< no search that comes later can succeed from here

  /** Looks for a way from a left vertex to a right one without mate, every other edge of which joins mates, and
   * exchanges the mates along it. */
  template <typename EdgesOf>
  void
  augment(std::uint32_t from, EdgesOf edges_of)
  {
    const std::uint32_t search = from + 1;
    queue_.assign(1, from);
    reached_.clear();
    std::uint32_t free = none;
    for (std::size_t i = 0; i < queue_.size() && free == none; ++i) {
      const std::uint32_t l = queue_[i];
      edges_of(l, [&](std::uint32_t r) {
        if (free != none || seen_[r] == failed || seen_[r] == search) {
          return;
        }
        seen_[r] = search;
        reached_from_[r] = l;
        reached_.push_back(r);
        if (right_mate_[r] == none) {
          free = r;
        }
        else {
          queue_.push_back(right_mate_[r]);
        }
      });
    }
    if (free == none) {
      for (const std::uint32_t r : reached_) {
        seen_[r] = failed;
      }
    }
    while (free != none) {
      const std::uint32_t l = reached_from_[free];
      right_mate_[free] = l;
      std::swap(left_mate_[l], free); // goes on with the former mate
    }
  }

  std::vector<std::uint32_t> left_mate_;
  std::vector<std::uint32_t> right_mate_;
  std::vector<std::uint32_t> reached_from_; ///< per right vertex: the left one through which the search came
  std::vector<std::uint32_t> seen_;         ///< per right vertex: number of the last search + 1
  std::vector<std::uint32_t> queue_;
  std::vector<std::uint32_t> reached_;
};

} // namespace symmetry
} // namespace pcl
