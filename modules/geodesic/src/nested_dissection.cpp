#include "geodesic/nested_dissection.h"

#include "geodesic/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t landmark_count = 6;

/** Numbers of edges to each landmark. */
using HopCounts = std::array<float, landmark_count>;

/** Breadth-first search: number of edges from a vertex to every other one, -1 where none leads there.
 * \param[out] found the vertices in the order found
 * \return how many there are */
std::size_t
countHops(const SurfaceGraph& graph, Index from, std::vector<std::int32_t>& hops, std::vector<Index>& found)
{
  hops.assign(graph.size(), -1);
  found.resize(graph.size() + 1); // one to spare: the next entry is written before it is known whether it counts
  found[0] = from;
  hops[from] = 0;
  std::size_t count = 1;
  constexpr std::size_t ahead = 8;
  for (std::size_t i = 0; i < count; ++i) {
    const Index v = found[i];
    const std::int32_t next = hops[v] + 1;
    if (i + ahead < count) {
      __builtin_prefetch(graph.neighbours.data() + graph.offsets[found[i + ahead]]);
    }
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      // Without a branch, which would be a guess every time.
      const Index w = graph.neighbours[e];
      const std::int32_t known = hops[w];
      found[count] = w;
      count += known < 0 ? 1U : 0U;
      hops[w] = known < 0 ? next : known;
    }
  }
  return count;
}

/** Number of edges from every vertex to a few landmarks, each of which is far from all before it. */
std::vector<HopCounts>
landmarkCoordinates(const SurfaceGraph& graph)
{
  std::vector<HopCounts> coordinates(graph.size());
  std::vector<std::int32_t> hops;
  std::vector<Index> found;
  std::vector<std::int32_t> nearest(graph.size(), std::numeric_limits<std::int32_t>::max());
  Index landmark = graph.size() == 0 ? no_index : 0;
  for (std::size_t k = 0; k < landmark_count && landmark != no_index; ++k) {
    countHops(graph, landmark, hops, found);
    landmark = no_index;
    std::int32_t farthest = -1;
    for (std::size_t v = 0; v < graph.size(); ++v) {
      // What cannot be reached is the landmark's affair no more than anyone's: as far as anything can be.
      const std::int32_t count = hops[v] < 0 ? static_cast<std::int32_t>(graph.size()) : hops[v];
      coordinates[v][k] = static_cast<float>(count);
      nearest[v] = std::min(nearest[v], count);
      if (nearest[v] > farthest) {
        farthest = nearest[v];
        landmark = static_cast<Index>(v);
      }
    }
  }
  return coordinates;
}

/** Direction in which a sample of vertices spreads most, by power iteration on their covariance. */
HopCounts
principalDirection(const std::vector<HopCounts>& coordinates, const Index* begin, const Index* end)
{
  constexpr std::ptrdiff_t sample = 128;
  constexpr int iterations = 12;
  const std::ptrdiff_t step = std::max<std::ptrdiff_t>(1, (end - begin) / sample);
  HopCounts mean{};
  float count = 0.0F;
  for (std::ptrdiff_t i = 0; i < end - begin; i += step) {
    count += 1.0F;
    for (std::size_t k = 0; k < landmark_count; ++k) {
      mean[k] += coordinates[begin[i]][k];
    }
  }
  std::array<HopCounts, landmark_count> covariance{};
  for (std::ptrdiff_t i = 0; i < end - begin; i += step) {
    HopCounts offset;
    for (std::size_t k = 0; k < landmark_count; ++k) {
      offset[k] = coordinates[begin[i]][k] - mean[k] / count;
    }
    for (std::size_t k = 0; k < landmark_count; ++k) {
      for (std::size_t l = 0; l < landmark_count; ++l) {
        covariance[k][l] += offset[k] * offset[l];
      }
    }
  }
  // From the coordinate that spreads most: it is not orthogonal to the principal direction.
  std::size_t widest = 0;
  for (std::size_t k = 1; k < landmark_count; ++k) {
    widest = covariance[k][k] > covariance[widest][widest] ? k : widest;
  }
  HopCounts direction{};
  direction[widest] = 1.0F;
  for (int i = 0; i < iterations; ++i) {
    HopCounts next{};
    float squared = 0.0F;
    for (std::size_t k = 0; k < landmark_count; ++k) {
      for (std::size_t l = 0; l < landmark_count; ++l) {
        next[k] += covariance[k][l] * direction[l];
      }
      squared += next[k] * next[k];
    }
    if (!(squared > 0.0F && squared < std::numeric_limits<float>::infinity())) {
      break;
    }
    for (std::size_t k = 0; k < landmark_count; ++k) {
      direction[k] = next[k] / std::sqrt(squared);
    }
  }
  return direction;
}

/** Unsigned number that rises with the value. */
std::uint32_t
sortableBits(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

/** Inverse of sortableBits (). */
float
valueOf(std::uint32_t bits)
{
  bits = (bits & 0x80000000U) != 0 ? bits & 0x7FFFFFFFU : ~bits;
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

class Dissector {
public:
  Dissector(const SurfaceGraph& graph, std::size_t largest_leaf)
      : graph_(graph),
        largest_leaf_(std::max<std::size_t>(largest_leaf, 1)),
        coordinates_(landmarkCoordinates(graph)),
        order_(graph.size()),
        part_(graph.size(), separator),
        keys_(graph.size()),
        sorted_(graph.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
  }

  Dissection
  run(unsigned threads)
  {
    Dissection dissection;
    dissection.nodes = split(0, order_.size(), threads);
    dissection.order = std::move(order_);
    return dissection;
  }

private:
  using Nodes = std::vector<Dissection::Node>;

  // What part_ says of a vertex of the piece at work. No edge joins two pieces, so a neighbour elsewhere is a
  // separator.
  static constexpr std::uint8_t separator = 0;
  static constexpr std::uint8_t lower_half = 1;
  static constexpr std::uint8_t upper_half = 2;

  /** Takes the vertices at positions [begin, end) apart. \return the nodes of the subtree, numbered from 0 */
  Nodes
  split(std::size_t begin, std::size_t end, unsigned threads)
  {
    constexpr std::size_t worth_a_thread = 2000;
    Dissection::Node top;
    top.begin = static_cast<std::uint32_t>(begin);
    top.end = static_cast<std::uint32_t>(end);
    if (end - begin <= largest_leaf_) {
      return {top};
    }
    const Parts parts = separate(begin, end);
    top.begin = static_cast<std::uint32_t>(parts.separator);
    Nodes nodes;
    Nodes more;
    if (threads > 1 && end - begin > worth_a_thread) {
      auto other = std::async(std::launch::async, [&] { return split(begin, parts.second, threads / 2); });
      more = split(parts.second, parts.separator, threads - threads / 2);
      nodes = other.get();
    }
    else {
      nodes = split(begin, parts.second, 1);
      more = split(parts.second, parts.separator, 1);
    }
    const auto offset = static_cast<std::int32_t>(nodes.size());
    for (Dissection::Node& node : more) {
      for (std::int32_t* number : {&node.parent, &node.children[0], &node.children[1]}) {
        *number += *number >= 0 ? offset : 0;
      }
    }
    nodes.insert(nodes.end(), more.begin(), more.end());
    const auto number = static_cast<std::int32_t>(nodes.size());
    top.children[0] = offset - 1;
    top.children[1] = number - 1;
    nodes[static_cast<std::size_t>(offset - 1)].parent = number;
    nodes[static_cast<std::size_t>(number - 1)].parent = number;
    nodes.push_back(top);
    return nodes;
  }

  /** [begin, second) and [second, separator) are the halves, [separator, end) the separator. */
  struct Parts {
    std::size_t second;
    std::size_t separator;
  };

  Parts
  separate(std::size_t begin, std::size_t end)
  {
    const Halves halves = sortByHalves(begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      part_[order_[i]] = i < halves.middle ? lower_half : upper_half;
    }
    std::vector<Index> borders[2];
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint8_t other = i < halves.middle ? upper_half : lower_half;
      if (keys_[i] >= halves.least_on_border && keys_[i] <= halves.largest_on_border && touches(order_[i], other)) {
        borders[i < halves.middle ? 0 : 1].push_back(order_[i]);
      }
    }
    const std::vector<Index>& border = borders[1].size() < borders[0].size() ? borders[1] : borders[0];
    for (const Index v : border) {
      part_[v] = separator;
    }
    // Both halves keep their order.
    std::size_t kept = begin;
    Parts parts{begin, begin};
    for (std::size_t i = begin; i < end; ++i) {
      if (i == halves.middle) {
        parts.second = kept;
      }
      const Index v = order_[i];
      order_[kept] = v;
      kept += part_[v] != separator ? 1U : 0U;
    }
    parts.separator = kept;
    std::copy(border.begin(), border.end(), order_.begin() + static_cast<std::ptrdiff_t>(kept));
    return parts;
  }

  bool
  touches(Index v, std::uint8_t part) const
  {
    for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
      if (part_[graph_.neighbours[e]] == part) {
        return true;
      }
    }
    return false;
  }

  /** [begin, middle) is one half; a vertex with a neighbour in the other half has a key between the two given. */
  struct Halves {
    std::size_t middle;
    std::uint64_t least_on_border;
    std::uint64_t largest_on_border;
  };

  /** Brings the vertices before the median of the principal direction to the front. */
  Halves
  sortByHalves(std::size_t begin, std::size_t end)
  {
    const Index* order = order_.data();
    const HopCounts direction = principalDirection(coordinates_, order + begin, order + end);
    float largest = 0.0F;
    for (std::size_t i = begin; i < end; ++i) {
      const HopCounts& position = coordinates_[order[i]];
      float along = 0.0F;
      for (std::size_t k = 0; k < landmark_count; ++k) {
        along += direction[k] * position[k];
      }
      largest = std::max(largest, std::abs(along));
      keys_[i] = std::uint64_t{sortableBits(along)} << 32U | static_cast<std::uint32_t>(order[i]);
    }
    const Median median = partitionNearMedian(begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      order_[i] = static_cast<Index>(keys_[i] & 0xFFFFFFFFU);
    }
    // Neighbours differ by at most 1 in every number of edges.
    float reach = 1e-5F * largest; // rounding
    for (const float part : direction) {
      reach += std::abs(part);
    }
    const float at = valueOf(static_cast<std::uint32_t>(median.key >> 32U));
    return {begin + median.lower, std::uint64_t{sortableBits(at - reach)} << 32U,
            std::uint64_t{sortableBits(at + reach)} << 32U | 0xFFFFFFFFU};
  }

  struct Median {
    std::size_t lower; ///< number of keys below it
    std::uint64_t key;
  };

  /** Brings the lower half of the keys to the front. The median of a sample is near enough; where it is not, the median
   * of all is found. */
  Median
  partitionNearMedian(std::size_t begin, std::size_t end)
  {
    constexpr std::size_t sample = 63;
    const std::size_t count = end - begin;
    std::uint64_t* keys = keys_.data() + begin;
    std::uint64_t picked[sample];
    for (std::size_t i = 0; i < sample; ++i) {
      picked[i] = keys[i * count / sample];
    }
    std::nth_element(picked, picked + sample / 2, picked + sample);
    const std::uint64_t pivot = picked[sample / 2];
    // Without a branch, which would be a guess: every key is written to both ends of what is left, and one counts.
    std::uint64_t* sorted = sorted_.data() + begin;
    std::size_t lower = 0;
    std::size_t upper = count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t key = keys[i];
      sorted[lower] = key;
      sorted[upper - 1] = key;
      const std::size_t is_lower = key < pivot ? 1 : 0;
      lower += is_lower;
      upper -= 1 - is_lower;
    }
    std::copy(sorted, sorted + count, keys);
    if (lower >= count / 3 && lower <= count - count / 3) {
      return {lower, pivot};
    }
    std::nth_element(keys, keys + count / 2, keys + count);
    return {count / 2, keys[count / 2]};
  }

  const SurfaceGraph& graph_;
  std::size_t largest_leaf_;
  std::vector<HopCounts> coordinates_;
  std::vector<Index> order_;
  std::vector<std::uint8_t> part_;  ///< of every vertex
  std::vector<std::uint64_t> keys_; ///< at every position: coordinate, then vertex
  std::vector<std::uint64_t> sorted_;
};

} // namespace

Dissection
dissect(const SurfaceGraph& graph, std::size_t largest_leaf, unsigned threads)
{
  return Dissector(graph, largest_leaf).run(threadCount(threads, graph.size()));
}

} // namespace symmetry
} // namespace pcl
