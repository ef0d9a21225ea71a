#include "symmetry/samples/surface_patch.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace pcl {
namespace symmetry {

SurfacePatch
patchAround(const CoarseSurface& coarse, Index centre, float radius)
{
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<float> field(coarse.size(), std::numeric_limits<float>::infinity());
  SurfacePatch patch;
  field[centre] = 0.0F;
  queue.push({0.0F, centre});
  while (!queue.empty()) {
    const auto [d, i] = queue.top();
    queue.pop();
    if (d > field[i]) {
      continue;
    }
    const float share = d / radius;
    patch.push_back({i, (1.0F - share * share) * (1.0F - share * share)});
    for (const auto [j, length] : coarse.graph.edges(i)) {
      const float through = d + length;
      if (through < radius && through < field[j]) {
        field[j] = through;
        queue.push({through, j});
      }
    }
  }
  std::sort(patch.begin(), patch.end(), [](const PatchMember& a, const PatchMember& b) { return a.sample < b.sample; });
  return patch;
}

} // namespace symmetry
} // namespace pcl
