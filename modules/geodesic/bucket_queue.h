/** \file
 * \brief The bucket queue behind every shortest-path search of this module.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Label-correcting shortest-path search over a ring of distance buckets (Dial's algorithm with real lengths).
 *
 * Vertices within one bucket are expanded in the order they came in, and again if a shorter way to them turns up, so
 * the distances are those of Dijkstra's algorithm to the last bit: the least of all path sums. The ring is wide enough
 * for the longest edge; very long edges widen the buckets instead of the ring. One object serves many searches on the
 * same graph, from one thread.
 */
class BucketQueue {
public:
  explicit BucketQueue(const SurfaceGraph& graph);

  /** \brief Lowers \a distances until no edge can lower them further, starting from the vertices in \a sources, whose
   * distances are set already.
   * \param[in] sources vertices to start from
   * \param[in,out] distances n values; a vertex is expanded only where a search improves on the value it finds
   * \param[in] on_improved called as (vertex, from) for every improvement
   */
  template <typename OnImproved>
  void
  relax(const std::vector<Index>& sources, float* distances, OnImproved on_improved)
  {
    constexpr std::size_t ahead = 4; // vertices whose edges are fetched in advance
    std::size_t pending = 0;
    std::size_t current = 0;
    for (const Index source : sources) {
      current = pending == 0 ? bucketOf(distances[source]) : std::min(current, bucketOf(distances[source]));
      push(source, bucketOf(distances[source]));
      ++pending;
    }
    while (pending > 0) {
      std::vector<Index>& bucket = ring_[current & mask_];
      for (std::size_t i = 0; i < bucket.size(); ++i) { // grows while it is worked off
        if (i + ahead < bucket.size()) {
          const std::uint32_t e = graph_.offsets[bucket[i + ahead]];
          __builtin_prefetch(graph_.neighbours.data() + e);
          __builtin_prefetch(graph_.lengths.data() + e);
        }
        const Index v = bucket[i];
        const float d = distances[v];
        if (d >= expanded_[v]) {
          continue;
        }
        expanded_[v] = d;
        touched_.push_back(v);
        for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
          const Index w = graph_.neighbours[e];
          const float candidate = d + graph_.lengths[e];
          if (candidate < distances[w]) {
            distances[w] = candidate;
            on_improved(w, v);
            push(w, std::max(bucketOf(candidate), current));
            ++pending;
          }
        }
      }
      pending -= bucket.size();
      bucket.clear();
      ++current;
    }
    reset();
  }

private:
  std::size_t
  bucketOf(float distance) const
  {
    return static_cast<std::size_t>(distance * inverse_width_);
  }

  void
  push(Index v, std::size_t bucket)
  {
    ring_[bucket & mask_].push_back(v);
  }

  void
  reset();

  const SurfaceGraph& graph_;
  float inverse_width_ = 1.0F;
  std::size_t mask_ = 0;
  std::vector<std::vector<Index>> ring_;
  std::vector<float> expanded_; ///< distance at which a vertex was last expanded
  std::vector<Index> touched_;
};

} // namespace symmetry
} // namespace pcl
