#include "base/parallel.h"
#include "geodesic/min_plus_factor.h"
#include "geodesic/min_plus_matrix.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** Sources that are swept together, so that the factor, which is larger than the caches, is read once for all of them.
 */
constexpr std::size_t largest_batch = 4 * kernel_lanes;

} // namespace

/** Distances from several sources at once, side by side: entry [position * width + source]. */
class MinPlusFactor::FieldBatch {
public:
  explicit FieldBatch(const MinPlusFactor& factor)
      : factor_(factor), table_(kernels()), is_above_(factor.fronts_.size())
  {
  }

  /** Finds the distances from sources that are sorted by position, at most largest_batch, and writes those of each to
   * its field, in the order of the vertices. */
  void
  run(const std::uint32_t* positions, float* const* fields, std::size_t sources)
  {
    width_ = roundedUp(sources, kernel_lanes);
    distances_.reserve((factor_.graph_.size() + min_plus_rows) * width_);
    std::fill_n(row(factor_.graph_.size()), min_plus_rows * width_, infinity);
    const std::size_t nodes = factor_.fronts_.size();
    markAbove(positions, sources);
    std::size_t source = 0;
    for (std::size_t node = 0; node < nodes; ++node) {
      if (is_above_[node] != 0) {
        sweepUp(node);
        for (; source < sources && factor_.node_at_[positions[source]] == node; ++source) {
          start(node, positions[source], source);
        }
      }
    }
    for (std::size_t node = nodes; node-- > 0;) {
      sweepDown(node);
    }
    for (std::size_t first = 0; first < sources; first += kernel_lanes) {
      store(first, fields + first, std::min(kernel_lanes, sources - first));
    }
  }

private:
  float*
  row(std::size_t position) const
  {
    return distances_.data() + position * width_;
  }

  void
  clearRows(std::size_t node)
  {
    std::fill_n(row(factor_.dissection_.nodes[node].begin), factor_.ownCount(node) * width_, infinity);
  }

  /** The nodes that have a source in their subtree. */
  void
  markAbove(const std::uint32_t* positions, std::size_t sources)
  {
    std::fill(is_above_.begin(), is_above_.end(), 0);
    for (std::size_t s = 0; s < sources; ++s) {
      for (auto node = static_cast<std::int32_t>(factor_.node_at_[positions[s]]); node >= 0 && is_above_[node] == 0;
           node = factor_.dissection_.nodes[node].parent) {
        is_above_[node] = 1;
        clearRows(static_cast<std::size_t>(node));
      }
    }
  }

  bool
  isAbove(std::int32_t node) const
  {
    return node >= 0 && is_above_[node] != 0;
  }

  /** Closes the distances that come from below within a node's subtree and hands them to its boundary. */
  void
  sweepUp(std::size_t node)
  {
    const std::int32_t* children = factor_.dissection_.nodes[node].children;
    if (!isAbove(children[0]) && !isAbove(children[1])) {
      return;
    }
    const Front& front = factor_.fronts_[node];
    const std::size_t count = factor_.ownCount(node);
    const std::size_t rows = roundedUp(count, min_plus_rows);
    float* own = row(factor_.dissection_.nodes[node].begin);
    float* gathered = gathered_.reserve(std::max(rows, front.boundary_stride) * width_);
    std::fill_n(gathered, rows * width_, infinity);
    table_.min_plus(gathered, width_, factor_.closure(node), front.own_stride, own, width_, rows, count, width_);
    std::copy_n(gathered, count * width_, own);

    float* transposed = transposed_.reserve(front.own_stride * front.boundary_stride);
    transposeBlocks(factor_.toBoundary(node), front.own_stride, front.boundary_stride, front.own_stride, transposed,
                    front.boundary_stride);
    std::fill_n(gathered, front.boundary_stride * width_, infinity);
    table_.min_plus(gathered, width_, transposed, front.boundary_stride, own, width_, front.boundary_stride, count,
                    width_);
    for (std::size_t b = 0; b < front.boundary_count; ++b) {
      float* to = row(factor_.boundary(node)[b]);
      for (std::size_t lane = 0; lane < width_; ++lane) {
        to[lane] = std::min(to[lane], gathered[b * width_ + lane]);
      }
    }
  }

  /** The distances from a source to the other vertices of its node and to the node's boundary are in the factor. */
  void
  start(std::size_t node, std::uint32_t position, std::size_t lane)
  {
    const Front& front = factor_.fronts_[node];
    const std::uint32_t begin = factor_.dissection_.nodes[node].begin;
    const float* to_own = factor_.closure(node) + (position - begin) * front.own_stride;
    for (std::size_t i = 0; i < factor_.ownCount(node); ++i) {
      float& distance = row(begin + i)[lane];
      distance = std::min(distance, to_own[i]);
    }
    const float* to_boundary = factor_.toBoundary(node) + (position - begin);
    for (std::size_t b = 0; b < front.boundary_count; ++b) {
      float& distance = row(factor_.boundary(node)[b])[lane];
      distance = std::min(distance, to_boundary[b * front.own_stride]);
    }
  }

  /** Lowers the distances of a node's vertices by ways that come from its boundary, whose distances are final. */
  void
  sweepDown(std::size_t node)
  {
    const Front& front = factor_.fronts_[node];
    if (is_above_[node] == 0) {
      clearRows(node);
    }
    table_.min_plus_picked(row(factor_.dissection_.nodes[node].begin), factor_.toBoundary(node), front.own_stride,
                           distances_.data(), factor_.boundary(node), roundedUp(factor_.ownCount(node), min_plus_rows),
                           front.boundary_count, width_);
  }

  /** Writes the distances of up to kernel_lanes sources, from lane first on, to their fields. */
  void
  store(std::size_t first, float* const* fields, std::size_t sources) const
  {
    const std::size_t n = factor_.graph_.size();
    const float* rows[kernel_lanes];
    constexpr std::size_t ahead = 4 * kernel_lanes; // neighbours in number need not be neighbours in position
    float tile[kernel_lanes][kernel_lanes];
    float* columns[kernel_lanes];
    for (std::size_t v = 0; v < n; v += kernel_lanes) {
      const std::size_t block = std::min(n - v, kernel_lanes);
      for (std::size_t i = 0; i < kernel_lanes; ++i) {
        rows[i] = row(factor_.position_[v + std::min(i, block - 1)]) + first;
        __builtin_prefetch(row(factor_.position_[std::min(v + i + ahead, n - 1)]) + first);
        columns[i] = i < sources && block == kernel_lanes ? fields[i] + v : tile[i];
      }
      table_.transpose_tile(rows, columns);
      for (std::size_t s = 0; block < kernel_lanes && s < sources; ++s) {
        std::copy_n(tile[s], block, fields[s] + v);
      }
    }
  }

  const MinPlusFactor& factor_;
  const KernelTable& table_;
  std::size_t width_ = 0; ///< sources, rounded up to whole registers
  FloatBlock distances_;
  std::vector<char> is_above_; ///< per node: a source is in its subtree
  FloatBlock gathered_;
  FloatBlock transposed_;
};

void
MinPlusFactor::fields(const std::vector<Index>& sources, float* rows) const
{
  // Sources that are close to each other have most of their way up in common.
  std::vector<std::uint32_t> order(sources.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return position_[sources[a]] < position_[sources[b]]; });
  const std::size_t share =
      (sources.size() + threadCount(sources.size()) - 1) / threadCount(sources.size()); // of a thread
  const std::size_t batch = std::min(largest_batch, roundedUp(share, kernel_lanes));
  parallelBlocks(sources.size(), batch, [&] {
    return [&, work = FieldBatch(*this)](std::size_t begin, std::size_t end) mutable {
      std::uint32_t positions[largest_batch];
      float* fields[largest_batch];
      const std::size_t count = end - begin;
      for (std::size_t s = 0; s < count; ++s) {
        positions[s] = position_[sources[order[begin + s]]];
        fields[s] = rows + order[begin + s] * graph_.size();
      }
      work.run(positions, fields, count);
    };
  });
}

} // namespace symmetry
} // namespace pcl
