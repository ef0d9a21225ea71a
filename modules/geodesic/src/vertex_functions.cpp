#include "geodesic/vertex_functions.h"

#include "geodesic/bucket_queue.h"
#include "geodesic/shortest_paths.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

std::vector<float>
smoothOverRings(const SurfaceGraph& graph, std::vector<float> values, int rounds)
{
  std::vector<float> smoothed(values.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < graph.size(); ++v) {
      float sum = values[v];
      for (const Index w : graph.neighboursOf(v)) {
        sum += values[w];
      }
      smoothed[v] = sum / static_cast<float>(graph.degree(v) + 1);
    }
    values.swap(smoothed);
  }
  return values;
}

std::vector<Index>
localMaxima(const SurfaceGraph& graph, const std::vector<float>& values)
{
  std::vector<Index> maxima;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const IndexRange around = graph.neighboursOf(v);
    const bool larger = std::all_of(around.begin(), around.end(), [&values, v](Index w) {
      return values[v] > values[w] || (values[v] == values[w] && v < static_cast<std::size_t>(w));
    });
    if (larger && !around.empty()) {
      maxima.push_back(static_cast<Index>(v));
    }
  }
  return maxima;
}

std::vector<Index>
separated(const SurfaceGraph& graph,
          const std::vector<Index>& vertices,
          const std::vector<float>& values,
          float separation)
{
  std::vector<Index> order = vertices;
  std::sort(order.begin(), order.end(),
            [&values](Index a, Index b) { return values[a] != values[b] ? values[a] > values[b] : a < b; });
  std::vector<Index> taken;
  std::vector<float> nearest(graph.size(), unreachable); // distance to the nearest vertex taken
  BucketQueue queue(graph);
  for (const Index v : order) {
    if (nearest[v] >= separation) {
      taken.push_back(v);
      nearest[v] = 0.0F;
      queue.relax({v}, nearest.data(), [](Index, Index) {});
    }
  }
  return taken;
}

} // namespace symmetry
} // namespace pcl
