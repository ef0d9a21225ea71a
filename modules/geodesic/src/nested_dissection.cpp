#include "geodesic/nested_dissection.h"

#include "base/parallel.h"
#include "geodesic/vertex_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t landmark_count = 6;

/** Numbers of edges to each landmark. */
using HopCounts = std::array<float, landmark_count>;

/** Calls use (w) for every neighbour w of a vertex, for some of them several times: always often enough for a vertex of
 * a mesh, so that the end of the loop is no guess. */
template <typename Use>
inline void
forNeighbours(const SurfaceGraph& graph, Index v, Use use)
{
  constexpr std::uint32_t at_least = 8;
  const std::uint32_t begin = graph.offsets[v];
  const std::uint32_t end = graph.offsets[v + 1];
  if (begin == end) {
    return;
  }
#pragma GCC unroll 8
  for (std::uint32_t i = 0; i < at_least; ++i) {
    use(graph.neighbours[std::min(begin + i, end - 1)]);
  }
  for (std::uint32_t e = begin + at_least; e < end; ++e) {
    use(graph.neighbours[e]);
  }
}

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
    forNeighbours(graph, v, [&](Index w) {
      // Without a branch, which would be a guess every time.
      const std::int32_t known = hops[w];
      found[count] = w;
      count += known < 0 ? 1U : 0U;
      hops[w] = known < 0 ? next : known;
    });
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

class Dissector {
public:
  Dissector(const SurfaceGraph& graph, std::size_t largest_leaf)
      : graph_(graph),
        largest_leaf_(std::max<std::size_t>(largest_leaf, 1)),
        coordinates_(landmarkCoordinates(graph)),
        order_(graph.size()),
        layer_(graph.size(), 1),
        number_(graph.size()),
        along_(graph.size()),
        highest_(graph.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
  }

  Dissection
  run(unsigned threads)
  {
    Dissection dissection;
    Scratch scratch;
    dissection.nodes = split(0, order_.size(), threads, scratch);
    dissection.order = std::move(order_);
    return dissection;
  }

private:
  using Nodes = std::vector<Dissection::Node>;

  // A piece is cut into layers along its direction. No edge joins two pieces, so a neighbour of a vertex of the piece
  // is in the piece or has this layer:
  static constexpr std::uint8_t separator = 0;
  static constexpr std::size_t maximum_layers = 128;

  struct Scratch {
    std::vector<Index> borders[2];
    std::vector<std::uint32_t> covers[2];
    std::vector<Index> moved;
    VertexCover cover;
  };

  /** Takes the vertices at positions [begin, end) apart. \return the nodes of the subtree, numbered from 0 */
  Nodes
  split(std::size_t begin, std::size_t end, unsigned threads, Scratch& scratch)
  {
    constexpr std::size_t worth_a_thread = 2000;
    Dissection::Node top;
    top.begin = static_cast<std::uint32_t>(begin);
    top.end = static_cast<std::uint32_t>(end);
    if (end - begin <= largest_leaf_) {
      return {top};
    }
    const Parts parts = separate(begin, end, scratch);
    top.begin = static_cast<std::uint32_t>(parts.separator);
    Nodes nodes;
    Nodes more;
    if (threads > 1 && end - begin > worth_a_thread) {
      auto other = std::async(std::launch::async, [&] {
        Scratch own;
        return split(begin, parts.second, threads / 2, own);
      });
      more = split(parts.second, parts.separator, threads - threads / 2, scratch);
      nodes = other.get();
    }
    else {
      nodes = split(begin, parts.second, 1, scratch);
      more = split(parts.second, parts.separator, 1, scratch);
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
  separate(std::size_t begin, std::size_t end, Scratch& scratch)
  {
    const std::uint8_t first_above = sortIntoLayers(begin, end);
    std::vector<Index>& border = scratch.borders[0];
    border.clear();
    for (std::size_t i = begin; i < end; ++i) {
      if (layer_[order_[i]] < first_above && highest_[i] >= first_above) {
        border.push_back(order_[i]);
      }
    }
    coverBorder(first_above, end - begin, scratch);
    for (const Index v : border) {
      layer_[v] = separator;
    }
    // Both halves keep their order. Without a branch, which would be a guess: every vertex is written to both, and
    // counts in one.
    scratch.moved.resize(end - begin + 1);
    std::size_t kept = begin;
    std::size_t moved = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order_[i];
      const std::uint8_t layer = layer_[v];
      order_[kept] = v;
      scratch.moved[moved] = v;
      kept += layer < first_above && layer != separator ? 1U : 0U;
      moved += layer >= first_above ? 1U : 0U;
    }
    const Parts parts{kept, kept + moved};
    std::copy_n(scratch.moved.begin(), moved, order_.begin() + static_cast<std::ptrdiff_t>(parts.second));
    std::copy(border.begin(), border.end(), order_.begin() + static_cast<std::ptrdiff_t>(parts.separator));
    return parts;
  }

  /** Replaces the border of the lower half by the fewest vertices that touch all edges between the halves. */
  void
  coverBorder(std::uint8_t first_above, std::size_t piece, Scratch& scratch)
  {
    std::vector<Index>& below = scratch.borders[0];
    std::vector<Index>& above = scratch.borders[1];
    above.clear();
    if (static_cast<double>(below.size()) > 16.0 * std::sqrt(static_cast<double>(piece))) {
      return; // no surface: a few vertices less would not help
    }
    for (const Index v : below) {
      for (const Index w : graph_.neighboursOf(v)) {
        if (layer_[w] >= first_above && !(number_[w] < above.size() && above[number_[w]] == w)) {
          number_[w] = static_cast<std::uint32_t>(above.size());
          above.push_back(w);
        }
      }
    }
    const auto edges_of = [&](std::uint32_t i, auto use) {
      const Index v = below[i];
      for (const Index w : graph_.neighboursOf(v)) {
        if (layer_[w] >= first_above) {
          use(number_[w]);
        }
      }
    };
    scratch.cover.find(below.size(), above.size(), edges_of, scratch.covers[0], scratch.covers[1]);
    std::size_t count = 0;
    for (const std::uint32_t i : scratch.covers[0]) {
      below[count++] = below[i]; // the numbers rise
    }
    below.resize(count);
    for (const std::uint32_t i : scratch.covers[1]) {
      below.push_back(above[i]);
    }
  }

  /** Finds the layer of every vertex of a piece. \return the first layer of the upper half */
  std::uint8_t
  sortIntoLayers(std::size_t begin, std::size_t end)
  {
    const HopCounts direction = principalDirection(coordinates_, order_.data() + begin, order_.data() + end);
    float least = std::numeric_limits<float>::infinity();
    float largest = -least;
    for (std::size_t i = begin; i < end; ++i) {
      const HopCounts& position = coordinates_[order_[i]];
      float along = 0.0F;
      for (std::size_t k = 0; k < landmark_count; ++k) {
        along += direction[k] * position[k];
      }
      along_[i] = along;
      least = std::min(least, along);
      largest = std::max(largest, along);
    }
    const std::size_t layers = end - begin < 1024 ? maximum_layers / 4 : maximum_layers;
    const float width = (largest - least) / static_cast<float>(layers);
    if (width > 0.0F) {
      const float per_length = 1.0F / width;
      const auto last = static_cast<std::int32_t>(layers - 1);
      for (std::size_t i = begin; i < end; ++i) {
        const auto layer = static_cast<std::int32_t>((along_[i] - least) * per_length);
        layer_[order_[i]] = static_cast<std::uint8_t>(1 + std::min(layer, last));
      }
      const std::uint8_t first_above = bestCut(begin, end, layers);
      if (first_above != separator) {
        return first_above;
      }
    }
    return cutAtMedian(begin, end);
  }

  /** Finds the highest layer next to every vertex of a piece, and where a cut between layers is short and near the
   * middle. \return the first layer above it; 0 where no cut is near the middle */
  std::uint8_t
  bestCut(std::size_t begin, std::size_t end, std::size_t layers)
  {
    std::int32_t counts[maximum_layers + 1] = {}; // vertices
    std::int32_t change[maximum_layers + 1] =
        {}; // vertices with a neighbour above, less those with none above from here on
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = order_[i];
      std::uint8_t highest = layer_[v];
      forNeighbours(graph_, v, [&](Index w) { highest = std::max(highest, layer_[w]); });
      highest_[i] = highest;
      ++counts[layer_[v]];
      ++change[layer_[v]];
      --change[highest];
    }
    const auto size = static_cast<std::int32_t>(end - begin);
    std::uint8_t best = separator;
    double least = std::numeric_limits<double>::infinity();
    std::int32_t below = 0;
    std::int32_t border = 0;
    for (std::size_t layer = 1; layer < layers; ++layer) {
      below += counts[layer];
      border += change[layer];
      if (below > size / 3 && below < size - size / 3) {
        const double off = static_cast<double>(below) / size - 0.5;
        const double cost = border * (1.0 + 12.0 * off * off);
        if (cost < least) {
          least = cost;
          best = static_cast<std::uint8_t>(layer + 1);
        }
      }
    }
    return best;
  }

  /** Two layers of the same number of vertices; ties by number. \return the upper one */
  std::uint8_t
  cutAtMedian(std::size_t begin, std::size_t end)
  {
    std::vector<std::pair<float, Index>> sorted;
    for (std::size_t i = begin; i < end; ++i) {
      sorted.emplace_back(along_[i], order_[i]);
    }
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (auto entry = sorted.begin(); entry != sorted.end(); ++entry) {
      layer_[entry->second] = entry < middle ? 1 : 2;
    }
    bestCut(begin, end, 2); // for the highest layers next to each
    return 2;
  }

  const SurfaceGraph& graph_;
  std::size_t largest_leaf_;
  std::vector<HopCounts> coordinates_;
  std::vector<Index> order_;
  std::vector<std::uint8_t> layer_;   ///< of every vertex
  std::vector<std::uint32_t> number_; ///< of every vertex of an upper border
  std::vector<float> along_;          ///< at every position: how far along the direction
  std::vector<std::uint8_t> highest_; ///< at every position: layer of the vertex or of one next to it
};

} // namespace

Dissection
dissect(const SurfaceGraph& graph, std::size_t largest_leaf)
{
  return Dissector(graph, largest_leaf).run(threadCount(graph.size()));
}

} // namespace symmetry
} // namespace pcl
