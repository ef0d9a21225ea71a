#include "geodesic/neighbour_graph.h"

#include "base/vector_math.h"

namespace pcl {
namespace symmetry {

SurfaceGraph
buildNeighbourGraph(const std::vector<Vector3>& points, const NeighbourLists& lists, float radius)
{
  std::vector<GraphEdge> edges;
  edges.reserve(lists.neighbours.size());
  for (std::size_t i = 0; i < lists.neighbours.size(); ++i) {
    const auto a = static_cast<Index>(i / lists.k);
    const Index b = lists.neighbours[i];
    if (b == no_index) {
      continue;
    }
    const float length = distance(points[a], points[b]);
    if (radius <= 0.0F || length <= radius) {
      edges.push_back({a, b, length});
    }
  }
  return buildGraph(points.size(), edges);
}

} // namespace symmetry
} // namespace pcl
