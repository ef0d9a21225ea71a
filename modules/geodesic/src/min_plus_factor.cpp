#include "geodesic/min_plus_factor.h"

#include "base/parallel.h"
#include "geodesic/min_plus_matrix.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t largest_leaf = 32;

} // namespace

MinPlusFactor::MinPlusFactor(const SurfaceGraph& graph, double maximum_field_cost)
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
  sortEdges();
  feasible_ = findBoundaries(maximum_field_cost);
}

/** Edges by position, each at the lower of its two. */
void
MinPlusFactor::sortEdges()
{
  edge_begin_.resize(graph_.size() + 1);
  edges_.resize(graph_.neighbours.size() / 2 + 1); // one to spare: the next entry is written before it counts
  std::uint32_t count = 0;
  for (std::size_t p = 0; p < graph_.size(); ++p) {
    edge_begin_[p] = count;
    const Index v = dissection_.order[p];
    for (const auto [w, length] : graph_.edges(v)) {
      const std::uint32_t other = position_[w];
      edges_[count] = {other, length};
      count += other > p ? 1U : 0U;
    }
  }
  edge_begin_[graph_.size()] = count;
}

/** Finds boundary by boundary, from the leaves up. */
class MinPlusFactor::BoundaryFinder {
public:
  explicit BoundaryFinder(const MinPlusFactor& factor) : factor_(factor), seen_(factor.graph_.size(), 0)
  {
  }

  /** The boundary of a node whose children have theirs. Nodes are asked for in their order. */
  const std::vector<std::uint32_t>&
  find(std::size_t node)
  {
    const Dissection::Node& own = factor_.dissection_.nodes[node];
    uniteChildren(own);
    for (const std::uint32_t position : united_) {
      seen_[position] = static_cast<std::uint32_t>(node + 1);
    }
    added_.clear();
    for (std::uint32_t e = factor_.edge_begin_[own.begin]; e < factor_.edge_begin_[own.end]; ++e) {
      const std::uint32_t position = factor_.edges_[e].position;
      if (position >= own.end && seen_[position] != node + 1) {
        seen_[position] = static_cast<std::uint32_t>(node + 1);
        added_.push_back(position);
      }
    }
    std::sort(added_.begin(), added_.end());
    found_.resize(united_.size() + added_.size());
    std::merge(united_.begin(), united_.end(), added_.begin(), added_.end(), found_.begin());
    return found_;
  }

private:
  void
  uniteChildren(const Dissection::Node& own)
  {
    const std::uint32_t* ranges[2][2] = {};
    for (std::size_t i = 0; i < 2; ++i) {
      if (own.children[i] >= 0) {
        const auto child = static_cast<std::size_t>(own.children[i]);
        const std::uint32_t* begin = factor_.boundary(child);
        const std::uint32_t* end = begin + factor_.fronts_[child].boundary_count;
        ranges[i][0] = std::lower_bound(begin, end, own.end);
        ranges[i][1] = end;
      }
    }
    united_.clear();
    std::set_union(ranges[0][0], ranges[0][1], ranges[1][0], ranges[1][1], std::back_inserter(united_));
  }

  const MinPlusFactor& factor_;
  std::vector<std::uint32_t> seen_; ///< per position: number of the last node + 1 in whose boundary it is
  std::vector<std::uint32_t> united_;
  std::vector<std::uint32_t> added_;
  std::vector<std::uint32_t> found_;
};

bool
MinPlusFactor::findBoundaries(double maximum_field_cost)
{
  BoundaryFinder finder(*this);
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    const std::vector<std::uint32_t>& boundary = finder.find(node);
    Front& front = fronts_[node];
    front.boundary = boundaries_.size();
    front.boundary_count = boundary.size();
    boundaries_.insert(boundaries_.end(), boundary.begin(), boundary.end());
    front.own_stride = roundedUp(ownCount(node), kernel_lanes);
    front.boundary_stride = roundedUp(boundary.size(), kernel_lanes);
    front.closure = closure_size_;
    front.to_boundary = to_boundary_size_;
    closure_size_ += front.own_stride * front.own_stride;
    to_boundary_size_ += front.boundary_stride * front.own_stride;
    const auto own_count = static_cast<double>(ownCount(node));
    const auto boundary_count = static_cast<double>(boundary.size());
    cost_.field += own_count * boundary_count;
    cost_.factor +=
        own_count * (own_count * own_count + own_count * boundary_count + 0.5 * boundary_count * boundary_count);
    if (cost_.field > maximum_field_cost) {
      return false;
    }
  }
  return true;
}

/** Matrices of the front at work. */
struct MinPlusFactor::FrontScratch {
  FloatBlock edges;    ///< own x boundary: before paths through the node's own vertices
  FloatBlock distance; ///< own x boundary: after
  FloatBlock panel;
  std::vector<FloatBlock> spare;     ///< updates that have been taken over
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
  float* among_own = closure(node);
  std::fill_n(among_own, front.own_stride * front.own_stride, infinity);
  float* to_boundary = scratch.edges.reserve(count * front.boundary_stride);
  std::fill_n(to_boundary, count * front.boundary_stride, infinity);
  if (!scratch.spare.empty()) {
    front.update = std::move(scratch.spare.back());
    scratch.spare.pop_back();
  }
  const std::size_t update_size = roundedUp(front.boundary_count, min_plus_rows) * front.boundary_stride;
  std::fill_n(front.update.reserve(update_size), update_size, infinity);
  scratch.place.resize(graph_.size());
  for (std::uint32_t p = own.begin; p < own.end; ++p) {
    scratch.place[p] = p - own.begin;
  }
  for (std::size_t b = 0; b < front.boundary_count; ++b) {
    scratch.place[boundary(node)[b]] = static_cast<std::uint32_t>(count + b);
  }
  for (const std::int32_t child : own.children) {
    if (child >= 0) {
      addUpdate(static_cast<std::size_t>(child), node, scratch);
    }
  }
  if (own.children[0] >= 0) {
    mirrorUpperTriangle(among_own, front.own_stride);
  }
  for (std::size_t i = 0; i < count; ++i) {
    among_own[i * front.own_stride + i] = 0.0F;
    for (std::uint32_t e = edge_begin_[own.begin + i]; e < edge_begin_[own.begin + i + 1]; ++e) {
      const std::size_t j = scratch.place[edges_[e].position];
      if (j < count) {
        const float length = std::min(among_own[i * front.own_stride + j], edges_[e].length);
        among_own[i * front.own_stride + j] = length;
        among_own[j * front.own_stride + i] = length;
      }
      else {
        float& entry = to_boundary[i * front.boundary_stride + j - count];
        entry = std::min(entry, edges_[e].length);
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
  const std::size_t size = below.boundary_count;
  scratch.places.resize(size);
  std::size_t inside = 0; // so many of the child's boundary are the node's own
  for (std::size_t b = 0; b < size; ++b) {
    scratch.places[b] = scratch.place[boundary(child)[b]];
    inside += scratch.places[b] < count ? 1U : 0U;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const float* from = below.update.data() + i * below.boundary_stride;
    const std::size_t row = scratch.places[i];
    float* to = nullptr;
    if (i < inside) {
      float* own = closure(node) + row * front.own_stride;
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
  scratch.spare.push_back(std::move(below.update));
}

void
MinPlusFactor::eliminate(std::size_t node, FrontScratch& scratch)
{
  assemble(node, scratch);
  Front& front = fronts_[node];
  const std::size_t count = ownCount(node);
  if (count == 0) {
    return;
  }
  closeSymmetric(closure(node), count, front.own_stride, scratch.panel);
  std::fill_n(scratch.distance.reserve(front.own_stride * front.boundary_stride),
              front.own_stride * front.boundary_stride, infinity);
  minPlus(scratch.distance.data(), front.boundary_stride, closure(node), front.own_stride, scratch.edges.data(),
          front.boundary_stride, roundedUp(count, min_plus_rows), count, front.boundary_stride);
  // The update is symmetric: of each block of columns only the rows down to the diagonal are needed.
  const std::size_t rows = roundedUp(front.boundary_count, min_plus_rows);
  constexpr std::size_t panel = 4 * kernel_lanes;
  for (std::size_t j = 0; j < front.boundary_stride; j += panel) {
    const std::size_t columns = std::min(panel, front.boundary_stride - j);
    minPlus(front.update.data() + j, front.boundary_stride, scratch.edges.data(), front.boundary_stride,
            scratch.distance.data() + j, front.boundary_stride, std::min(rows, j + columns), count, columns);
  }
  transposeBlocks(scratch.distance.data(), front.boundary_stride, front.own_stride, front.boundary_stride,
                  toBoundary(node), front.own_stride);
}

void
MinPlusFactor::factorize()
{
  closure_.reserve(closure_size_);
  to_boundary_.reserve(to_boundary_size_);
  // Subtrees that share no node are independent of each other. The nodes of a subtree are numbered one after another.
  constexpr std::size_t subtrees_per_thread = 4;
  const std::size_t maximum_size = graph_.size() / (subtrees_per_thread * threadCount(graph_.size())) + 1;
  std::vector<std::pair<std::size_t, std::size_t>> subtrees; // first node and the one after the last
  std::vector<std::size_t> above;                            // nodes that belong to none
  std::size_t first = 0;                                     // the first node after those of the subtrees found
  for (std::size_t node = 0; node < fronts_.size(); ++node) {
    const std::int32_t parent = dissection_.nodes[node].parent;
    if (subtreeSize(node) > maximum_size) {
      above.push_back(node);
      first = node + 1;
    }
    else if (parent < 0 || subtreeSize(static_cast<std::size_t>(parent)) > maximum_size) {
      subtrees.emplace_back(first, node + 1);
      first = node + 1;
    }
  }
  parallelBlocks(subtrees.size(), 1, [&] {
    return [&, scratch = FrontScratch()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t node = subtrees[i].first; node < subtrees[i].second; ++node) {
          eliminate(node, scratch);
        }
      }
    };
  });
  FrontScratch scratch;
  for (const std::size_t node : above) {
    eliminate(node, scratch);
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

} // namespace symmetry
} // namespace pcl
