#include "symmetry/search/moved_ends.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

MovedEnds::MovedEnds(const LandmarkSurface& landmarks)
    : landmarks_(landmarks), ends_(extremitiesOf(landmarks, limb_separation, most_limbs))
{
}

float
MovedEnds::share(const SampleMap& map) const
{
  constexpr std::size_t head_and_tail = 2;
  if (ends_.size() <= head_and_tail) {
    return 0.0F;
  }
  const auto moved = std::count_if(ends_.begin(), ends_.end(), [&](Index end) {
    return landmarks_.distances(end, map[end]) > limb_separation * landmarks_.diameter;
  });
  return std::min(1.0F, static_cast<float>(moved) / static_cast<float>(ends_.size() - head_and_tail));
}

} // namespace symmetry
} // namespace pcl
