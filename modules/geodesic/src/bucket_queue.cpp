#include "geodesic/bucket_queue.h"

#include <algorithm>

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

BucketQueue::BucketQueue(const SurfaceGraph& graph) : graph_(graph)
{
  // Several maxima side by side: one alone would wait for each comparison to end before it begins the next.
  constexpr std::size_t lanes = 16;
  float longest_of[lanes] = {};
  const std::size_t count = graph.lengths.size();
  for (std::size_t e = 0; e < count; e += lanes) {
    const float* some = graph.lengths.data() + std::min(e, count - std::min(count, lanes)); // the last overlap
    for (std::size_t i = 0; i < std::min(count, lanes); ++i) {
      longest_of[i] = std::max(longest_of[i], some[i]);
    }
  }
  const float longest = *std::max_element(longest_of, longest_of + lanes);
  // Half the mean edge length, as a few thousand edges tell it: narrow enough that few vertices are expanded twice,
  // wide enough that few buckets are empty.
  const std::size_t step = std::max<std::size_t>(1, count / 4096);
  double sum = 0.0;
  for (std::size_t e = 0; e < count; e += step) {
    sum += graph.lengths[e];
  }
  const std::size_t summed = (count + step - 1) / step;
  double width = count == 0 ? 1.0 : 0.5 * sum / static_cast<double>(summed);
  width = std::max(width, static_cast<double>(longest) / static_cast<double>(largest_ring - 4));
  if (!(width > 0.0)) {
    width = 1.0; // every edge has length zero
  }
  inverse_width_ = static_cast<float>(1.0 / width);
  const std::size_t ring = powerOfTwoAbove(static_cast<std::size_t>(longest / width) + 3);
  mask_ = ring - 1;
  ring_.resize(ring);
}

} // namespace symmetry
} // namespace pcl
