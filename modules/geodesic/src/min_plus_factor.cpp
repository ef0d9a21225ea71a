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

/** Sources that are swept together. Twice as many were no faster: their distances leave the cache. */
constexpr std::size_t batch_width = kernel_lanes;

std::size_t
roundedUp(std::size_t count, std::size_t multiple)
{
  return (count + multiple - 1) / multiple * multiple;
}

/** KernelTable::min_plus, its columns shared out among threads where that is worth their start. */
void
minPlus(float* result,
        std::size_t result_stride,
        const float* left,
        std::size_t left_stride,
        const float* right,
        std::size_t right_stride,
        std::size_t rows,
        std::size_t depth,
        std::size_t columns,
        unsigned threads)
{
  constexpr std::size_t worth_threads = 4000000; // about 0.2 ms
  const std::size_t parts = rows * depth * columns < worth_threads ? 1 : 2 * threadCount(threads, columns);
  const std::size_t grain = roundedUp(std::max<std::size_t>(1, (columns + parts - 1) / parts), kernel_lanes);
  parallelBlocks(columns, grain, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      kernels().min_plus(result + begin, result_stride, left, left_stride, right + begin, right_stride, rows, depth,
                         end - begin);
    };
  });
}

/** Shortest paths among all pairs, in place: Floyd's algorithm by blocks.
 * \param[in,out] matrix symmetric, count x count; the stride is a multiple of kernel_lanes \param[in] panel scratch */
void
closeSymmetric(
    std::vector<float>& matrix, std::size_t count, std::size_t stride, std::vector<float>& panel, unsigned threads)
{
  const KernelTable& table = kernels();
  panel.resize(kernel_lanes * stride);
  for (std::size_t k = 0; k < count; k += kernel_lanes) {
    float* rows = matrix.data() + k * stride;
    table.close_tile(rows + k, stride);
    // Rows k .. of the matrix, with paths through the vertices of the tile; the tile is its own transpose.
    std::copy(rows, rows + kernel_lanes * stride, panel.begin());
    table.min_plus(panel.data(), stride, rows + k, stride, rows, stride, kernel_lanes, kernel_lanes, stride);
    minPlus(matrix.data(), stride, panel.data(), stride, panel.data(), stride, roundedUp(count, min_plus_rows),
            kernel_lanes, stride, threads);
  }
}

/** Transposes a matrix in whole blocks of kernel_lanes x kernel_lanes: to has columns_blocks of rows, from rows_blocks.
 */
void
transposeBlocks(
    const float* from, std::size_t from_stride, std::size_t rows, std::size_t columns, float* to, std::size_t to_stride)
{
  const KernelTable& table = kernels();
  const float* tile_rows[kernel_lanes];
  float* tile_columns[kernel_lanes];
  for (std::size_t i = 0; i < rows; i += kernel_lanes) {
    for (std::size_t j = 0; j < columns; j += kernel_lanes) {
      for (std::size_t k = 0; k < kernel_lanes; ++k) {
        tile_rows[k] = from + (i + k) * from_stride + j;
        tile_columns[k] = to + (j + k) * to_stride + i;
      }
      table.transpose_tile(tile_rows, tile_columns);
    }
  }
}

/** Makes a matrix symmetric of which only the upper triangle is filled in. */
void
mirrorUpperTriangle(float* matrix, std::size_t stride)
{
  for (std::size_t i = 0; i < stride; i += kernel_lanes) {
    for (std::size_t row = i; row < i + kernel_lanes; ++row) {
      for (std::size_t column = i; column < row; ++column) {
        matrix[row * stride + column] = matrix[column * stride + row];
      }
    }
    if (i > 0) {
      transposeBlocks(matrix + i, stride, i, kernel_lanes, matrix + i * stride, stride);
    }
  }
}

} // namespace

MinPlusFactor::MinPlusFactor(const SurfaceGraph& graph, double most_field_cost, unsigned threads)
    : graph_(graph),
      dissection_(dissect(graph, largest_leaf, threads)),
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
    Front& front = fronts_[node];
    front.own_stride = roundedUp(ownCount(node), kernel_lanes);
    front.boundary_stride = roundedUp(boundary.size(), kernel_lanes);
    front.to_boundary = to_boundary_size_;
    to_boundary_size_ += front.boundary_stride * front.own_stride;
    const auto own_count = static_cast<double>(own.end - own.begin);
    const auto boundary_count = static_cast<double>(boundary.size());
    cost_.field += own_count * boundary_count;
    cost_.factor +=
        own_count * (own_count * own_count + own_count * boundary_count + 0.5 * boundary_count * boundary_count);
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
  mirrorUpperTriangle(front.closure.data(), front.own_stride);
  for (std::size_t i = 0; i < count; ++i) {
    front.closure[i * front.own_stride + i] = 0.0F;
    const Index v = dissection_.order[own.begin + i];
    for (std::uint32_t e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
      const std::uint32_t p = position_[graph_.neighbours[e]];
      if (p >= own.begin) { // an edge to a vertex below is that vertex's
        const std::size_t j = scratch.place[p];
        float& entry =
            j < count ? front.closure[i * front.own_stride + j] : scratch.edges[i * front.boundary_stride + j - count];
        entry = std::min(entry, graph_.lengths[e]);
      }
    }
  }
}

/** Takes the distances within a child's boundary over into the front. The boundary is sorted, so that the upper
 * triangle goes to the upper triangle. */
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
MinPlusFactor::eliminate(std::size_t node, FrontScratch& scratch, unsigned threads)
{
  assemble(node, scratch);
  Front& front = fronts_[node];
  const std::size_t count = ownCount(node);
  if (count == 0) {
    return;
  }
  closeSymmetric(front.closure, count, front.own_stride, scratch.panel, threads);
  scratch.distance.assign(front.own_stride * front.boundary_stride, infinity);
  minPlus(scratch.distance.data(), front.boundary_stride, front.closure.data(), front.own_stride, scratch.edges.data(),
          front.boundary_stride, roundedUp(count, min_plus_rows), count, front.boundary_stride, threads);
  // The update is symmetric: of each block of columns only the rows down to the diagonal are needed.
  const std::size_t rows = roundedUp(front.boundary.size(), min_plus_rows);
  constexpr std::size_t panel = 4 * kernel_lanes;
  for (std::size_t j = 0; j < front.boundary_stride; j += panel) {
    const std::size_t columns = std::min(panel, front.boundary_stride - j);
    minPlus(front.update.data() + j, front.boundary_stride, scratch.edges.data(), front.boundary_stride,
            scratch.distance.data() + j, front.boundary_stride, std::min(rows, j + columns), count, columns, threads);
  }
  transposeBlocks(scratch.distance.data(), front.boundary_stride, front.own_stride, front.boundary_stride,
                  to_boundary_.get() + front.to_boundary, front.own_stride);
}

void
MinPlusFactor::factorize(unsigned threads)
{
  to_boundary_.reset(new float[to_boundary_size_]);
  // Subtrees that share no node are independent of each other. The nodes of a subtree are numbered one after another.
  constexpr std::size_t subtrees_per_thread = 4;
  const std::size_t most = graph_.size() / (subtrees_per_thread * threadCount(threads, graph_.size())) + 1;
  std::vector<std::pair<std::size_t, std::size_t>> subtrees; // first node and the one after the last
  std::vector<std::size_t> above;                            // nodes that belong to none
  std::size_t first = 0;                                     // the first node after those of the subtrees found
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    const std::int32_t parent = dissection_.nodes[node].parent;
    if (subtreeSize(node) > most) {
      above.push_back(node);
      first = node + 1;
    }
    else if (parent < 0 || subtreeSize(static_cast<std::size_t>(parent)) > most) {
      subtrees.emplace_back(first, node + 1);
      first = node + 1;
    }
  }
  parallelBlocks(subtrees.size(), 1, threads, [&] {
    return [&, scratch = FrontScratch()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t node = subtrees[i].first; node < subtrees[i].second; ++node) {
          eliminate(node, scratch, 1);
        }
      }
    };
  });
  FrontScratch scratch;
  for (const std::size_t node : above) {
    eliminate(node, scratch, threads);
  }
}

std::size_t
MinPlusFactor::subtreeSize(std::size_t node) const
{
  std::size_t lowest = node;
  while (dissection_.nodes[lowest].children[0] >= 0) {
    lowest = static_cast<std::size_t>(dissection_.nodes[lowest].children[0]);
  }
  return dissection_.nodes[node].end - dissection_.nodes[lowest].begin;
}

/** Distances from several sources at once, side by side: entry [position * batch_width + source]. */
class MinPlusFactor::FieldBatch {
public:
  explicit FieldBatch(const MinPlusFactor& factor)
      : factor_(factor),
        table_(kernels()),
        distances_((factor.graph_.size() + min_plus_rows) * batch_width),
        is_above_(factor.fronts_.size())
  {
  }

  /** \param[in] sources at most batch_width */
  void
  run(const std::uint32_t* positions, std::size_t sources)
  {
    std::fill(distances_.begin(), distances_.end(), infinity);
    std::fill(is_above_.begin(), is_above_.end(), 0);
    for (std::size_t s = 0; s < sources; ++s) {
      distances_[positions[s] * batch_width + s] = 0.0F;
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

  /** Writes the distances of each source to its field, in the order of the vertices. */
  void
  store(float* const* fields, std::size_t sources) const
  {
    const std::size_t n = factor_.graph_.size();
    const float* rows[kernel_lanes];
    constexpr std::size_t ahead = 4 * kernel_lanes; // neighbours in number need not be neighbours in position
    float tile[kernel_lanes][kernel_lanes];
    float* columns[kernel_lanes];
    for (std::size_t v = 0; v < n; v += kernel_lanes) {
      const std::size_t block = std::min(n - v, kernel_lanes);
      for (std::size_t i = 0; i < kernel_lanes; ++i) {
        rows[i] = at(factor_.position_[v + std::min(i, block - 1)]);
        __builtin_prefetch(at(factor_.position_[std::min(v + i + ahead, n - 1)]));
        columns[i] = i < sources && block == kernel_lanes ? fields[i] + v : tile[i];
      }
      table_.transpose_tile(rows, columns);
      for (std::size_t s = 0; block < kernel_lanes && s < sources; ++s) {
        std::copy_n(tile[s], block, fields[s] + v);
      }
    }
  }

private:
  const float*
  at(std::uint32_t position) const
  {
    return distances_.data() + position * batch_width;
  }

  float*
  ownDistances(std::size_t node)
  {
    return distances_.data() + factor_.dissection_.nodes[node].begin * batch_width;
  }

  /** Closes the distances of a node's vertices within its subtree and hands them to its boundary. */
  void
  sweepUp(std::size_t node)
  {
    const Front& front = factor_.fronts_[node];
    const std::size_t count = factor_.ownCount(node);
    const std::size_t rows = roundedUp(count, min_plus_rows);
    float* own = ownDistances(node);
    gathered_.assign(rows * batch_width, infinity);
    table_.min_plus(gathered_.data(), batch_width, front.closure.data(), front.own_stride, own, batch_width, rows,
                    count, batch_width);
    std::copy_n(gathered_.begin(), count * batch_width, own);

    transposed_.resize(front.own_stride * front.boundary_stride);
    transposeBlocks(factor_.to_boundary_.get() + front.to_boundary, front.own_stride, front.boundary_stride,
                    front.own_stride, transposed_.data(), front.boundary_stride);
    gathered_.assign(front.boundary_stride * batch_width, infinity);
    table_.min_plus(gathered_.data(), batch_width, transposed_.data(), front.boundary_stride, own, batch_width,
                    front.boundary_stride, count, batch_width);
    for (std::size_t b = 0; b < front.boundary.size(); ++b) {
      float* to = distances_.data() + front.boundary[b] * batch_width;
      for (std::size_t lane = 0; lane < batch_width; ++lane) {
        to[lane] = std::min(to[lane], gathered_[b * batch_width + lane]);
      }
    }
  }

  /** Lowers the distances of a node's vertices by ways that come from its boundary, whose distances are final. */
  void
  sweepDown(std::size_t node)
  {
    const Front& front = factor_.fronts_[node];
    table_.min_plus_picked(ownDistances(node), factor_.to_boundary_.get() + front.to_boundary, front.own_stride,
                           distances_.data(), front.boundary.data(), roundedUp(factor_.ownCount(node), min_plus_rows),
                           front.boundary.size(), batch_width);
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
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return position_[sources[a]] < position_[sources[b]]; });
  parallelBlocks(sources.size(), batch_width, threads, [&] {
    return [&, batch = FieldBatch(*this)](std::size_t begin, std::size_t end) mutable {
      std::uint32_t positions[batch_width];
      float* fields[batch_width];
      const std::size_t count = end - begin;
      for (std::size_t s = 0; s < count; ++s) {
        positions[s] = position_[sources[order[begin + s]]];
        fields[s] = rows + order[begin + s] * graph_.size();
      }
      batch.run(positions, count);
      batch.store(fields, count);
    };
  });
}

} // namespace symmetry
} // namespace pcl
