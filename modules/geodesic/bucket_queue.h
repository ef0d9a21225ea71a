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

/** \brief Label-correcting shortest-path search over a ring of distance buckets (Dial's algorithm
 * \cite dial1969algorithm with real lengths).
 *
 * Vertices within one bucket are expanded in the order they came in, and again if a shorter way to them turns up, so
 * the distances are those of Dijkstra's algorithm to the last bit: the least of all path sums. Where lengths differ by orders of
 * magnitude one bucket may hold most vertices, and would expand each of them hundreds of times: what is more than a crowd in
 * it is expanded nearest first, as Dijkstra's algorithm does. The ring is wide enough
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
    std::size_t pending = 0;
    std::size_t current = 0;
    for (const Index source : sources) {
      const std::size_t bucket = bucketOf(distances[source]);
      current = pending == 0 ? bucket : std::min(current, bucket);
      push({source, distances[source]}, bucket);
      ++pending;
    }
    for (; pending > 0; ++current) {
      std::vector<Entry>& bucket = ring_[current & mask_];
      for (std::size_t i = 0; i < std::min(bucket.size(), crowd); ++i) { // grows while it is worked off
        prefetchEdges(bucket, i);
        pending += expand(bucket[i], current, distances, on_improved);
      }
      std::make_heap(bucket.begin() + static_cast<std::ptrdiff_t>(std::min(bucket.size(), crowd)), bucket.end(),
                     isFarther);
      while (bucket.size() > crowd) {
        const Entry nearest = takeNearest(bucket);
        const std::size_t before = bucket.size();
        pending += expand(nearest, current, distances, on_improved);
        --pending;
        enter(bucket, before);
      }
      pending -= bucket.size();
      bucket.clear();
    }
  }

private:
  struct Entry {
    Index vertex;
    float distance; ///< of a way to it
  };

  static constexpr std::uint32_t at_a_time = 32; // edges of a vertex
  static constexpr std::size_t crowd = 4096;     // entries of a bucket; fronts of a million points have some thousand

  static bool
  isFarther(const Entry& a, const Entry& b)
  {
    return a.distance > b.distance;
  }

  /** Of a crowded bucket, whose entries beyond a crowd are a heap. */
  static Entry
  takeNearest(std::vector<Entry>& bucket)
  {
    std::pop_heap(bucket.begin() + static_cast<std::ptrdiff_t>(crowd), bucket.end(), isFarther);
    const Entry nearest = bucket.back();
    bucket.pop_back();
    return nearest;
  }

  /** Makes the entries of a crowded bucket from number \a before on part of its heap. */
  static void
  enter(std::vector<Entry>& bucket, std::size_t before)
  {
    for (std::size_t size = before + 1; size <= bucket.size(); ++size) {
      std::push_heap(bucket.begin() + static_cast<std::ptrdiff_t>(crowd),
                     bucket.begin() + static_cast<std::ptrdiff_t>(size), isFarther);
    }
  }

  /** Lowers the distances of the neighbours, unless a shorter way has been found since; the number of new entries. */
  template <typename OnImproved>
  std::size_t
  expand(const Entry entry, std::size_t current, float* distances, OnImproved& on_improved)
  {
    if (entry.distance > distances[entry.vertex]) {
      return 0;
    }
    std::size_t entries = 0;
    for (std::uint32_t e = graph_.offsets[entry.vertex]; e < graph_.offsets[entry.vertex + 1]; e += at_a_time) {
      Entry improved[at_a_time];
      const std::size_t count = findImproved(entry, e, distances, improved);
      for (std::size_t k = 0; k < count; ++k) {
        distances[improved[k].vertex] = improved[k].distance;
        on_improved(improved[k].vertex, entry.vertex);
        push(improved[k], std::max(bucketOf(improved[k].distance), current));
      }
      entries += count;
    }
    return entries;
  }

  /** Some of the edges of a vertex from edge e on: those that are shorter ways to where they lead. Without a branch,
   * which would be a guess for every edge.
   *
   * \return how many there are */
  std::size_t
  findImproved(const Entry& from, std::uint32_t e, const float* distances, Entry* improved) const
  {
    const std::uint32_t end = std::min(graph_.offsets[from.vertex + 1], e + at_a_time);
    std::size_t count = 0;
    for (; e < end; ++e) {
      const Entry candidate{graph_.neighbours[e], from.distance + graph_.lengths[e]};
      improved[count] = candidate;
      count += candidate.distance < distances[candidate.vertex] ? 1U : 0U;
    }
    return count;
  }

  void
  prefetchEdges(const std::vector<Entry>& bucket, std::size_t i) const
  {
    constexpr std::size_t ahead = 4;
    if (i + ahead < bucket.size()) {
      const std::uint32_t e = graph_.offsets[bucket[i + ahead].vertex];
      __builtin_prefetch(graph_.neighbours.data() + e);
      __builtin_prefetch(graph_.lengths.data() + e);
    }
  }

  std::size_t
  bucketOf(float distance) const
  {
    // By way of a signed number, for which there is an instruction.
    return static_cast<std::size_t>(static_cast<std::int64_t>(distance * inverse_width_));
  }

  void
  push(const Entry& entry, std::size_t bucket)
  {
    ring_[bucket & mask_].push_back(entry);
  }

  const SurfaceGraph& graph_;
  float inverse_width_ = 1.0F;
  std::size_t mask_ = 0;
  std::vector<std::vector<Entry>> ring_;
};

} // namespace symmetry
} // namespace pcl
