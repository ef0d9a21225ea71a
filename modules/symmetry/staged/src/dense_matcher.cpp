#include "symmetry/staged/dense_matcher.h"

#include "base/parallel.h"
#include "kernels/kernels.h"
#include "symmetry/staged/feature_kernels.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::uint32_t leaf_size = 16;

} // namespace

DenseMatcher::DenseMatcher(const FeatureVectors& candidates, std::vector<float> floors)
    : dimensions_(candidates.dimensions),
      padded_((candidates.dimensions + feature_lanes - 1) / feature_lanes * feature_lanes),
      floors_(std::move(floors)),
      order_(candidates.rows())
{
  std::iota(order_.begin(), order_.end(), 0U);
  if (order_.empty()) {
    return;
  }
  nodes_.push_back({0, static_cast<std::uint32_t>(order_.size()), 0});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) { // grows while it is worked off
    if (nodes_[node].end - nodes_[node].begin > leaf_size) {
      split(candidates, node);
    }
    else {
      // Ascending rows: of equal candidates of a leaf the first one found is the lowest.
      std::sort(order_.begin() + nodes_[node].begin, order_.begin() + nodes_[node].end);
    }
  }
  storeCandidates(candidates);
  boundNodes();
}

std::size_t
DenseMatcher::widestFeature(const FeatureVectors& candidates, const Node& node) const
{
  // A few dozen candidates tell which feature is wide. Widths count relative to the values, as in the dissimilarity.
  const std::uint32_t step = std::max<std::uint32_t>(1, (node.end - node.begin) / 48);
  std::vector<float> least(dimensions_, std::numeric_limits<float>::infinity());
  std::vector<float> largest(dimensions_, 0.0F);
  for (std::uint32_t entry = node.begin; entry < node.end; entry += step) {
    const float* values = candidates.row(order_[entry]);
    for (std::size_t i = 0; i < dimensions_; ++i) {
      least[i] = std::min(least[i], values[i]);
      largest[i] = std::max(largest[i], values[i]);
    }
  }
  std::size_t widest = 0;
  float width = -1.0F;
  for (std::size_t i = 0; i < dimensions_; ++i) {
    const float relative = (largest[i] - least[i]) * featureWeight(0.5F * (least[i] + largest[i]), floors_[i]);
    if (relative > width) {
      width = relative;
      widest = i;
    }
  }
  return widest;
}

void
DenseMatcher::split(const FeatureVectors& candidates, std::uint32_t node)
{
  const Node parent = nodes_[node];
  const std::size_t feature = widestFeature(candidates, parent);
  const std::uint32_t middle = parent.begin + (parent.end - parent.begin) / 2;
  std::nth_element(order_.begin() + parent.begin, order_.begin() + middle, order_.begin() + parent.end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float value_a = candidates.row(a)[feature];
                     const float value_b = candidates.row(b)[feature];
                     return value_a != value_b ? value_a < value_b : a < b;
                   });
  nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({parent.begin, middle, 0});
  nodes_.push_back({middle, parent.end, 0});
}

void
DenseMatcher::storeCandidates(const FeatureVectors& candidates)
{
  features_.assign(order_.size() * padded_, 0.0F);
  for (std::size_t entry = 0; entry < order_.size(); ++entry) {
    const float* values = candidates.row(order_[entry]);
    std::copy(values, values + dimensions_, features_.begin() + static_cast<std::ptrdiff_t>(entry * padded_));
  }
}

void
DenseMatcher::boundNodes()
{
  lower_.assign(nodes_.size() * padded_, std::numeric_limits<float>::infinity());
  upper_.assign(nodes_.size() * padded_, -std::numeric_limits<float>::infinity());
  const auto include = [this](std::size_t node, const float* lower, const float* upper) {
    for (std::size_t i = 0; i < padded_; ++i) {
      lower_[node * padded_ + i] = std::min(lower_[node * padded_ + i], lower[i]);
      upper_[node * padded_ + i] = std::max(upper_[node * padded_ + i], upper[i]);
    }
  };
  for (std::size_t node = nodes_.size(); node-- > 0;) { // children before parents
    const Node& box = nodes_[node];
    if (box.children == 0) {
      for (std::size_t entry = box.begin; entry < box.end; ++entry) {
        include(node, &features_[entry * padded_], &features_[entry * padded_]);
      }
    }
    else {
      include(node, &lower_[box.children * padded_], &upper_[box.children * padded_]);
      include(node, &lower_[(box.children + 1) * padded_], &upper_[(box.children + 1) * padded_]);
    }
  }
}

/** Answers one query after another; a query near the one before it starts from that one's match. */
class DenseMatcher::Search {
public:
  explicit Search(const DenseMatcher& tree) : tree_(tree), query_(tree.padded_, 0.0F), weights_(tree.padded_, 0.0F)
  {
  }

  FeatureMatch
  best(const float* query)
  {
    for (std::size_t i = 0; i < tree_.dimensions_; ++i) {
      query_[i] = query[i];
      weights_[i] = featureWeight(query[i], tree_.floors_[i]);
    }
    best_ = {-1, std::numeric_limits<float>::infinity()};
    evaluate(last_entry_, last_entry_ + 1);
    descend(0);
    return best_;
  }

private:
  /** Candidates [begin, end), at most as many as a leaf has. */
  void
  evaluate(std::size_t begin, std::size_t end)
  {
    float values[leaf_size];
    table_.weighted_distances(query_.data(), &tree_.features_[begin * tree_.padded_], end - begin, weights_.data(),
                              tree_.padded_, values);
    for (std::size_t entry = begin; entry < end; ++entry) {
      const float value = values[entry - begin];
      const auto row = static_cast<std::ptrdiff_t>(tree_.order_[entry]);
      if (value < best_.dissimilarity || (value == best_.dissimilarity && row < best_.row) || best_.row < 0) {
        best_ = {row, value};
        last_entry_ = entry;
      }
    }
  }

  void
  descend(std::uint32_t node)
  {
    const Node& box = tree_.nodes_[node];
    if (box.children == 0) {
      evaluate(box.begin, box.end);
      return;
    }
    float bounds[2];
    table_.weighted_box_distances(query_.data(), &tree_.lower_[box.children * tree_.padded_],
                                  &tree_.upper_[box.children * tree_.padded_], 2, weights_.data(), tree_.padded_,
                                  bounds);
    const std::uint32_t nearer = bounds[1] < bounds[0] ? 1 : 0;
    for (const std::uint32_t child : {nearer, 1 - nearer}) {
      if (bounds[child] <= best_.dissimilarity) { // equal ones too: a tie may have a lower row
        descend(box.children + child);
      }
    }
  }

  const DenseMatcher& tree_;
  const KernelTable& table_ = kernels();
  std::vector<float> query_;
  std::vector<float> weights_;
  FeatureMatch best_;
  std::size_t last_entry_ = 0;
};

std::vector<FeatureMatch>
DenseMatcher::match(const FeatureVectors& queries) const
{
  constexpr std::size_t block = 256; // neighbours in number are mostly neighbours on the surface
  std::vector<FeatureMatch> matches(queries.rows());
  if (order_.empty()) {
    return matches;
  }
  parallelBlocks(queries.rows(), block, [&] {
    return [&, search = Search(*this)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        matches[i] = search.best(queries.row(i));
      }
    };
  });
  return matches;
}

} // namespace symmetry
} // namespace pcl
