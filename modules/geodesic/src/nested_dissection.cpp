#include "geodesic/nested_dissection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t landmark_count = 6;

/** Numbers of edges to each landmark. */
using HopCounts = std::array<float, landmark_count>;

/** Breadth-first search: number of edges from a vertex to every other one, -1 where none leads there.
 * \return the vertices in the order found */
std::vector<Index>
countHops(const SurfaceGraph& graph, Index from, std::vector<std::int32_t>& hops)
{
  hops.assign(graph.size(), -1);
  std::vector<Index> found{from};
  found.reserve(graph.size());
  hops[from] = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Index v = found[i];
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const Index w = graph.neighbours[e];
      if (hops[w] < 0) {
        hops[w] = hops[v] + 1;
        found.push_back(w);
      }
    }
  }
  return found;
}

/** Number of edges from every vertex to a few landmarks, each of which is far from all before it. */
std::vector<HopCounts>
landmarkCoordinates(const SurfaceGraph& graph)
{
  std::vector<HopCounts> coordinates(graph.size());
  std::vector<std::int32_t> hops;
  std::vector<std::int32_t> nearest(graph.size(), std::numeric_limits<std::int32_t>::max());
  Index landmark = graph.size() == 0 ? no_index : countHops(graph, 0, hops).back();
  for (std::size_t k = 0; k < landmark_count && landmark != no_index; ++k) {
    countHops(graph, landmark, hops);
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

class Dissector {
public:
  Dissector(const SurfaceGraph& graph, std::size_t largest_leaf)
      : graph_(graph), largest_leaf_(largest_leaf), coordinates_(landmarkCoordinates(graph)), side_(graph.size(), 0)
  {
    result_.order.resize(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v) {
      result_.order[v] = static_cast<Index>(v);
    }
    keys_.resize(graph.size());
  }

  Dissection
  run()
  {
    split(0, result_.order.size());
    return std::move(result_);
  }

private:
  /** Takes the vertices at positions [begin, end) apart. \return number of the node at the top */
  std::int32_t
  split(std::size_t begin, std::size_t end)
  {
    Dissection::Node node;
    node.end = static_cast<std::uint32_t>(end);
    std::size_t separator = begin;
    if (end - begin > largest_leaf_) {
      const Parts parts = separate(begin, end);
      separator = parts.separator;
      node.children[0] = split(begin, parts.second);
      node.children[1] = split(parts.second, parts.separator);
    }
    node.begin = static_cast<std::uint32_t>(separator);
    const auto number = static_cast<std::int32_t>(result_.nodes.size());
    for (const std::int32_t child : node.children) {
      if (child >= 0) {
        result_.nodes[static_cast<std::size_t>(child)].parent = number;
      }
    }
    result_.nodes.push_back(node);
    return number;
  }

  /** [begin, second) and [second, separator) are the halves, [separator, end) the separator. */
  struct Parts {
    std::size_t second;
    std::size_t separator;
  };

  Parts
  separate(std::size_t begin, std::size_t end)
  {
    Index* order = result_.order.data();
    sortByHalves(begin, end);
    const std::size_t middle = begin + (end - begin) / 2;
    stamp_ += 2; // of the first half; that of the second is one more
    for (std::size_t i = begin; i < end; ++i) {
      side_[order[i]] = i < middle ? stamp_ : stamp_ + 1;
    }
    borders_[0].clear();
    borders_[1].clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order[i];
      if (touches(v, side_[v] == stamp_ ? stamp_ + 1 : stamp_)) {
        borders_[i < middle ? 0 : 1].push_back(v);
      }
    }
    const std::vector<Index>& separator = borders_[borders_[1].size() < borders_[0].size() ? 1 : 0];
    for (const Index v : separator) {
      side_[v] = 0;
    }
    // Both halves keep their order.
    std::size_t kept = begin;
    Parts parts{begin, begin};
    for (std::size_t i = begin; i < end; ++i) {
      if (i == middle) {
        parts.second = kept;
      }
      if (side_[order[i]] != 0) {
        order[kept++] = order[i];
      }
    }
    parts.separator = kept;
    std::copy(separator.begin(), separator.end(), order + kept);
    return parts;
  }

  bool
  touches(Index v, std::uint32_t side) const
  {
    for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
      if (side_[graph_.neighbours[e]] == side) {
        return true;
      }
    }
    return false;
  }

  /** Brings the vertices before the median of the principal direction to the front. */
  void
  sortByHalves(std::size_t begin, std::size_t end)
  {
    Index* order = result_.order.data();
    const HopCounts direction = principalDirection(coordinates_, order + begin, order + end);
    for (std::size_t i = begin; i < end; ++i) {
      const HopCounts& position = coordinates_[order[i]];
      float along = 0.0F;
      for (std::size_t k = 0; k < landmark_count; ++k) {
        along += direction[k] * position[k];
      }
      keys_[i] = std::uint64_t{sortableBits(along)} << 32U | static_cast<std::uint32_t>(order[i]);
    }
    const auto first = keys_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = keys_.begin() + static_cast<std::ptrdiff_t>(end);
    std::nth_element(first, first + (last - first) / 2, last);
    for (std::size_t i = begin; i < end; ++i) {
      order[i] = static_cast<Index>(keys_[i] & 0xFFFFFFFFU);
    }
  }

  const SurfaceGraph& graph_;
  std::size_t largest_leaf_;
  std::vector<HopCounts> coordinates_;
  std::vector<std::uint32_t> side_; ///< stamp of the half that holds the vertex; 0: in a separator
  std::uint32_t stamp_ = 0;
  std::vector<Index> borders_[2];
  std::vector<std::uint64_t> keys_;
  Dissection result_;
};

} // namespace

Dissection
dissect(const SurfaceGraph& graph, std::size_t largest_leaf)
{
  return Dissector(graph, largest_leaf).run();
}

} // namespace symmetry
} // namespace pcl
