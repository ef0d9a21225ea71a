#include "geodesic/vertex_functions.h"

namespace pcl {
namespace symmetry {

std::vector<float>
smoothOverRings(const SurfaceGraph& graph, std::vector<float> values, int rounds)
{
  std::vector<float> smoothed(values.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < graph.size(); ++v) {
      float sum = values[v];
      for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
        sum += values[graph.neighbours[e]];
      }
      smoothed[v] = sum / static_cast<float>(graph.offsets[v + 1] - graph.offsets[v] + 1);
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
    bool larger = graph.offsets[v + 1] > graph.offsets[v];
    for (std::uint32_t e = graph.offsets[v]; larger && e < graph.offsets[v + 1]; ++e) {
      const auto w = static_cast<std::size_t>(graph.neighbours[e]);
      larger = values[v] > values[w] || (values[v] == values[w] && v < w);
    }
    if (larger) {
      maxima.push_back(static_cast<Index>(v));
    }
  }
  return maxima;
}

} // namespace symmetry
} // namespace pcl
