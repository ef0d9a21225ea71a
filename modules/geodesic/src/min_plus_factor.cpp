#include "geodesic/min_plus_factor.h"

#include "geodesic/parallel.h"
#include "kernels/kernels.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::size_t largest_leaf = 32;

std::size_t
roundedUp(std::size_t count, std::size_t multiple)
{
  return (count + multiple - 1) / multiple * multiple;
}

/** Shortest paths among all pairs, in place: Floyd's algorithm by blocks.
 * \param[in,out] matrix symmetric, stride x stride, a multiple of kernel_lanes \param[in] panel scratch */
void
closeSymmetric(std::vector<float>& matrix, std::size_t stride, std::vector<float>& panel)
{
  const KernelTable& table = kernels();
  panel.resize(kernel_lanes * stride);
  for (std::size_t k = 0; k < stride; k += kernel_lanes) {
    float* rows = matrix.data() + k * stride;
    table.close_tile(rows + k, stride);
    // Rows k .. of the matrix, with paths through the vertices of the tile; the tile is its own transpose.
    std::copy(rows, rows + kernel_lanes * stride, panel.begin());
    table.min_plus(panel.data(), stride, rows + k, stride, rows, stride, kernel_lanes, kernel_lanes, stride);
    table.min_plus(matrix.data(), stride, panel.data(), stride, panel.data(), stride, stride, kernel_lanes, stride);
  }
}

/** Transposes a rows x columns matrix; both strides are multiples of kernel_lanes, what lies beyond is taken along. */
void
transpose(const float* from, std::size_t from_stride, std::size_t rows, std::size_t columns, float* to, std::size_t to_stride)
{
  for (std::size_t i = 0; i < rows; i += kernel_lanes) {
    const std::size_t end = std::min(rows, i + kernel_lanes);
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t r = i; r < end; ++r) {
        to[j * to_stride + r] = from[r * from_stride + j];
      }
    }
  }
}

} // namespace

MinPlusFactor::MinPlusFactor(const SurfaceGraph& graph, double most_field_cost)
    : graph_(graph),
      dissection_(dissect(graph, largest_leaf)),
      position_(graph.size()),
      node_at_(graph.size()),
      fronts_(dissection_.nodes.size())
{
  for (std::size_t p = 0; p < graph.size(); ++p) {
    position_[dissection_.order[p]] = static_cast<std::uint32_t>(p);
  }
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    std::fill(node_at_.begin() + dissection_.nodes[node].begin, node_at_.begin() + dissection_.nodes[node].end,
              static_cast<std::uint32_t>(node));
  }
  feasible_ = findBoundaries(most_field_cost);
}

bool
MinPlusFactor::findBoundaries(double most_field_cost)
{
  std::vector<std::uint32_t> seen(graph_.size(), 0); // number of the last node + 1 in whose boundary the position is
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    const Dissection::Node& own = dissection_.nodes[node];
    std::vector<std::uint32_t>& boundary = fronts_[node].boundary;
    const auto add = [&](std::uint32_t position) {
      if (position >= own.end && seen[position] != node + 1) {
        seen[position] = static_cast<std::uint32_t>(node + 1);
        boundary.push_back(position);
      }
    };
    for (const std::int32_t child : own.children) {
      if (child >= 0) {
        const std::vector<std::uint32_t>& below = fronts_[static_cast<std::size_t>(child)].boundary;
        std::for_each(below.begin(), below.end(), add);
      }
    }
    for (std::uint32_t p = own.begin; p < own.end; ++p) {
      const Index v = dissection_.order[p];
      for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
        add(position_[graph_.neighbours[e]]);
      }
    }
    std::sort(boundary.begin(), boundary.end());
    const auto own_count = static_cast<double>(own.end - own.begin);
    const auto boundary_count = static_cast<double>(boundary.size());
    cost_.field += own_count * boundary_count;
    cost_.factor += own_count * (own_count * own_count + own_count * boundary_count +
                                 0.5 * boundary_count * boundary_count);
    if (cost_.field > most_field_cost) {
      return false;
    }
  }
  return true;
}

/** Matrices of the front at work. */
struct MinPlusFactor::FrontScratch {
  std::vector<float> edges;    ///< own x boundary: before paths through the node's own vertices
  std::vector<float> distance; ///< own x boundary: after
  std::vector<float> panel;
  std::vector<std::uint32_t> place;  ///< of every position of the graph: where it is in the front
  std::vector<std::uint32_t> places; ///< of every position of a child's boundary
};

/** Distances between the vertices of a node, and from them to its boundary, that use no vertex of the node in between.
 */
void
MinPlusFactor::assemble(std::size_t node, FrontScratch& scratch)
{
  const Dissection::Node& own = dissection_.nodes[node];
  Front& front = fronts_[node];
  const std::size_t count = ownCount(node);
  front.own_stride = roundedUp(count, kernel_lanes);
  front.boundary_stride = roundedUp(front.boundary.size(), kernel_lanes);
  front.closure.assign(front.own_stride * front.own_stride, infinity);
  scratch.edges.assign(count * front.boundary_stride, infinity);
  front.update.assign(roundedUp(front.boundary.size(), min_plus_rows) * front.boundary_stride, infinity);
  scratch.place.resize(graph_.size());
  for (std::uint32_t p = own.begin; p < own.end; ++p) {
    scratch.place[p] = p - own.begin;
  }
  for (std::size_t b = 0; b < front.boundary.size(); ++b) {
    scratch.place[front.boundary[b]] = static_cast<std::uint32_t>(count + b);
  }
  for (const std::int32_t child : own.children) {
    if (child >= 0) {
      addUpdate(static_cast<std::size_t>(child), node, scratch);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) { // the updates filled the upper triangle
      front.closure[i * front.own_stride + j] = front.closure[j * front.own_stride + i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    front.closure[i * front.own_stride + i] = 0.0F;
    const Index v = dissection_.order[own.begin + i];
    for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
      const std::uint32_t p = position_[graph_.neighbours[e]];
      if (p >= own.begin) { // an edge to a vertex below is that vertex's
        const std::size_t j = scratch.place[p];
        float& entry = j < count ? front.closure[i * front.own_stride + j]
                                 : scratch.edges[i * front.boundary_stride + j - count];
        entry = std::min(entry, graph_.lengths[e]);
      }
    }
  }
}

/** Takes the distances within a child's boundary over into the front. The boundary is sorted, so that the upper triangle
 * goes to the upper triangle. */
void
MinPlusFactor::addUpdate(std::size_t child, std::size_t node, FrontScratch& scratch)
{
  Front& front = fronts_[node];
  Front& below = fronts_[child];
  const std::size_t count = ownCount(node);
  const std::size_t size = below.boundary.size();
  scratch.places.resize(size);
  std::size_t inside = 0; // so many of the child's boundary are the node's own
  for (std::size_t b = 0; b < size; ++b) {
    scratch.places[b] = scratch.place[below.boundary[b]];
    inside += scratch.places[b] < count ? 1U : 0U;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const float* from = below.update.data() + i * below.boundary_stride;
    const std::size_t row = scratch.places[i];
    float* to = nullptr;
    if (i < inside) {
      float* own = front.closure.data() + row * front.own_stride;
      for (std::size_t j = i; j < inside; ++j) {
        own[scratch.places[j]] = std::min(own[scratch.places[j]], from[j]);
      }
      to = scratch.edges.data() + row * front.boundary_stride;
    }
    else {
      to = front.update.data() + (row - count) * front.boundary_stride;
    }
    for (std::size_t j = std::max(i, inside); j < size; ++j) {
      float& entry = to[scratch.places[j] - count];
      entry = std::min(entry, from[j]);
    }
  }
  below.update = std::vector<float>();
}

void
MinPlusFactor::eliminate(std::size_t node, FrontScratch& scratch)
{
  const KernelTable& table = kernels();
  assemble(node, scratch);
  Front& front = fronts_[node];
  const std::size_t count = ownCount(node);
  if (count == 0) {
    return;
  }
  closeSymmetric(front.closure, front.own_stride, scratch.panel);
  scratch.distance.assign(front.own_stride * front.boundary_stride, infinity);
  table.min_plus(scratch.distance.data(), front.boundary_stride, front.closure.data(), front.own_stride,
                 scratch.edges.data(), front.boundary_stride, roundedUp(count, min_plus_rows), count,
                 front.boundary_stride);
  // The update is symmetric: of each block of columns only the rows down to the diagonal are needed.
  const std::size_t rows = roundedUp(front.boundary.size(), min_plus_rows);
  for (std::size_t j = 0; j < front.boundary_stride; j += kernel_lanes) {
    table.min_plus(front.update.data() + j, front.boundary_stride, scratch.edges.data(), front.boundary_stride,
                   scratch.distance.data() + j, front.boundary_stride, std::min(rows, j + kernel_lanes), count,
                   kernel_lanes);
  }
  front.to_boundary.assign(front.boundary.size() * front.own_stride, infinity);
  transpose(scratch.distance.data(), front.boundary_stride, count, front.boundary.size(), front.to_boundary.data(),
            front.own_stride);
}

void
MinPlusFactor::factorize(unsigned threads)
{
  static_cast<void>(threads);
  FrontScratch scratch;
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    eliminate(node, scratch);
  }
}

/** Distances from kernel_lanes sources at once, side by side: entry [position * kernel_lanes + source]. */
class MinPlusFactor::FieldBatch {
public:
  explicit FieldBatch(const MinPlusFactor& factor)
      : factor_(factor),
        table_(kernels()),
        distances_((factor.graph_.size() + min_plus_rows) * kernel_lanes),
        is_above_(factor.fronts_.size())
  {
  }

  /** \param[in] sources at most kernel_lanes */
  void
  run(const std::uint32_t* positions, std::size_t sources)
  {
    std::fill(distances_.begin(), distances_.end(), infinity);
    std::fill(is_above_.begin(), is_above_.end(), 0);
    for (std::size_t s = 0; s < sources; ++s) {
      distances_[positions[s] * kernel_lanes + s] = 0.0F;
      for (auto node = static_cast<std::int32_t>(factor_.node_at_[positions[s]]); node >= 0 && is_above_[node] == 0;
           node = factor_.dissection_.nodes[node].parent) {
        is_above_[node] = 1;
      }
    }
    const std::size_t nodes = factor_.fronts_.size();
    for (std::size_t node = 0; node < nodes; ++node) {
      if (is_above_[node] != 0) {
        sweepUp(node);
      }
    }
    for (std::size_t node = nodes; node-- > 0;) {
      sweepDown(node);
    }
  }

  const float*
  at(std::uint32_t position) const
  {
    return distances_.data() + position * kernel_lanes;
  }

private:
  float*
  ownDistances(std::size_t node)
  {
    return distances_.data() + std::size_t{factor_.dissection_.nodes[node].begin} * kernel_lanes;
  }

  /** Closes the distances of a node's vertices within its subtree and hands them to its boundary. */
  void
  sweepUp(std::size_t node)
  {
    const Front& front = factor_.fronts_[node];
    const std::size_t count = factor_.ownCount(node);
    const std::size_t rows = roundedUp(count, min_plus_rows);
    float* own = ownDistances(node);
    gathered_.assign(rows * kernel_lanes, infinity);
    table_.min_plus(gathered_.data(), kernel_lanes, front.closure.data(), front.own_stride, own, kernel_lanes, rows,
                    count, kernel_lanes);
    std::copy_n(gathered_.begin(), count * kernel_lanes, own);

    const std::size_t boundary_rows = roundedUp(front.boundary.size(), min_plus_rows);
    transposed_.assign(count * boundary_rows, infinity);
    transpose(front.to_boundary.data(), front.own_stride, front.boundary.size(), count, transposed_.data(),
              boundary_rows);
    gathered_.assign(boundary_rows * kernel_lanes, infinity);
    table_.min_plus(gathered_.data(), kernel_lanes, transposed_.data(), boundary_rows, own, kernel_lanes,
                    boundary_rows, count, kernel_lanes);
    for (std::size_t b = 0; b < front.boundary.size(); ++b) {
      float* to = distances_.data() + std::size_t{front.boundary[b]} * kernel_lanes;
      for (std::size_t lane = 0; lane < kernel_lanes; ++lane) {
        to[lane] = std::min(to[lane], gathered_[b * kernel_lanes + lane]);
      }
    }
  }

  /** Lowers the distances of a node's vertices by ways that come from its boundary, whose distances are final. */
  void
  sweepDown(std::size_t node)
  {
    const Front& front = factor_.fronts_[node];
    gathered_.resize(front.boundary.size() * kernel_lanes);
    for (std::size_t b = 0; b < front.boundary.size(); ++b) {
      std::copy_n(distances_.data() + std::size_t{front.boundary[b]} * kernel_lanes, kernel_lanes,
                  gathered_.data() + b * kernel_lanes);
    }
    table_.min_plus(ownDistances(node), kernel_lanes, front.to_boundary.data(), front.own_stride, gathered_.data(),
                    kernel_lanes, roundedUp(factor_.ownCount(node), min_plus_rows), front.boundary.size(),
                    kernel_lanes);
  }

  const MinPlusFactor& factor_;
  const KernelTable& table_;
  std::vector<float> distances_;
  std::vector<char> is_above_; ///< per node: a source is in its subtree
  std::vector<float> gathered_;
  std::vector<float> transposed_;
};

void
MinPlusFactor::fields(const std::vector<Index>& sources, float* rows, unsigned threads) const
{
  // Sources that are close to each other have most of their way up in common.
  std::vector<std::uint32_t> order(sources.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return position_[sources[a]] < position_[sources[b]];
  });
  const std::size_t n = graph_.size();
  parallelBlocks(sources.size(), kernel_lanes, threads, [&] {
    return [&, batch = FieldBatch(*this)](std::size_t begin, std::size_t end) mutable {
      std::uint32_t positions[kernel_lanes];
      float* fields[kernel_lanes];
      const std::size_t count = end - begin;
      for (std::size_t s = 0; s < count; ++s) {
        positions[s] = position_[sources[order[begin + s]]];
        fields[s] = rows + order[begin + s] * n;
      }
      batch.run(positions, count);
      for (std::size_t v = 0; v < n; v += kernel_lanes) {
        const std::size_t block = std::min(n - v, kernel_lanes);
        float tile[kernel_lanes][kernel_lanes];
        for (std::size_t i = 0; i < block; ++i) {
          std::copy_n(batch.at(position_[v + i]), kernel_lanes, tile[i]);
        }
        for (std::size_t s = 0; s < count; ++s) {
          for (std::size_t i = 0; i < block; ++i) {
            fields[s][v + i] = tile[i][s];
          }
        }
      }
    };
  });
}

} // namespace symmetry
} // namespace pcl
