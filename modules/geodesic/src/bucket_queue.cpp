#include "geodesic/bucket_queue.h"

#include <algorithm>
#include <limits>

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
  double sum = 0.0;
  float longest = 0.0F;
  for (const float length : graph.lengths) {
    sum += length;
    longest = std::max(longest, length);
  }
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
