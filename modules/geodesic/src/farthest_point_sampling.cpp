#include "geodesic/farthest_point_sampling.h"

#include "base/heartbeat.h"
#include "geodesic/bucket_queue.h"
#include "geodesic/shortest_paths.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Largest finite distances per block of vertices, so that the search for the farthest vertex reads a block again only
 * where a front has lowered something in it. */
class BlockMaxima {
public:
  explicit BlockMaxima(const std::vector<float>& distance)
      : distance_(distance), best_((distance.size() + block_size - 1) / block_size), stale_(best_.size(), 1)
  {
  }

  void
  touch(Index v)
  {
    stale_[static_cast<std::size_t>(v) / block_size] = 1;
  }

  Index
  farthest()
  {
    Index best = no_index;
    for (std::size_t block = 0; block < best_.size(); ++block) {
      if (stale_[block] != 0) {
        best_[block] = scan(block);
        stale_[block] = 0;
      }
      const Index candidate = best_[block];
      if (candidate != no_index && (best == no_index || distance_[candidate] > distance_[best])) {
        best = candidate;
      }
    }
    return best;
  }

private:
  static constexpr std::size_t block_size = 256;

  Index
  scan(std::size_t block) const
  {
    Index best = no_index;
    const std::size_t end = std::min(distance_.size(), (block + 1) * block_size);
    for (std::size_t v = block * block_size; v < end; ++v) {
      if (distance_[v] < unreachable && (best == no_index || distance_[v] > distance_[best])) {
        best = static_cast<Index>(v);
      }
    }
    return best;
  }

  const std::vector<float>& distance_;
  std::vector<Index> best_;
  std::vector<char> stale_;
};

} // namespace

FarthestPointSamples
farthestPointSampling(const SurfaceGraph& graph, Index start, std::size_t count)
{
  FarthestPointSamples samples;
  samples.owner.assign(graph.size(), no_index);
  samples.distance.assign(graph.size(), unreachable);
  BucketQueue queue(graph);
  BlockMaxima maxima(samples.distance);
  Index next = start;
  while (samples.vertices.size() < count && next != no_index && samples.distance[next] > 0.0F) {
    heartbeat();
    const auto number = static_cast<Index>(samples.vertices.size());
    samples.vertices.push_back(next);
    samples.radii.push_back(samples.distance[next]);
    samples.distance[next] = 0.0F;
    samples.owner[next] = number;
    maxima.touch(next);
    queue.relax({next}, samples.distance.data(), [&](Index v, Index) {
      samples.owner[v] = number;
      maxima.touch(v);
    });
    next = maxima.farthest();
  }
  return samples;
}

} // namespace symmetry
} // namespace pcl
