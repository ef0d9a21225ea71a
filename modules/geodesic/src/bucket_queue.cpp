#include "geodesic/bucket_queue.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t largest_ring = 4096;

std::size_t
powerOfTwoAbove(std::size_t value)
{
  std::size_t power = 4;
  while (power < value) {
    power *= 2;
  }
  return power;
}

} // namespace

BucketQueue::BucketQueue(const SurfaceGraph& graph)
    : graph_(graph), expanded_(graph.size(), std::numeric_limits<float>::infinity())
{
  // Several sums side by side: one alone would wait for each addition to end before it begins the next.
  constexpr std::size_t sums = 8;
  double partial[sums] = {};
  float longest_of[sums] = {};
  for (std::size_t e = 0; e < graph.lengths.size(); ++e) {
    partial[e % sums] += graph.lengths[e];
    longest_of[e % sums] = std::max(longest_of[e % sums], graph.lengths[e]);
  }
  const double sum = std::accumulate(partial, partial + sums, 0.0);
  const float longest = *std::max_element(longest_of, longest_of + sums);
  // Half the mean edge length: narrow enough that few vertices are expanded twice, wide enough that few buckets are
  // empty.
  double width = graph.lengths.empty() ? 1.0 : 0.5 * sum / static_cast<double>(graph.lengths.size());
  width = std::max(width, static_cast<double>(longest) / static_cast<double>(largest_ring - 4));
  if (!(width > 0.0)) {
    width = 1.0; // every edge has length zero
  }
  inverse_width_ = static_cast<float>(1.0 / width);
  const std::size_t ring = powerOfTwoAbove(static_cast<std::size_t>(longest / width) + 3);
  mask_ = ring - 1;
  ring_.resize(ring);
}

void
BucketQueue::reset()
{
  for (const Index v : touched_) {
    expanded_[v] = std::numeric_limits<float>::infinity();
  }
  touched_.clear();
}

} // namespace symmetry
} // namespace pcl
