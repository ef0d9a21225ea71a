#include "geodesic/surface_graph.h"

#include "base/heartbeat.h"
#include "base/vector_math.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

struct HalfEdge {
  Index to;
  float length;
};

/** Edges grouped by vertex, both directions of each, in the order given. */
void
scatterHalfEdges(std::size_t n,
                 const std::vector<GraphEdge>& edges,
                 std::vector<std::uint32_t>& offsets,
                 std::vector<HalfEdge>& half_edges)
{
  offsets.assign(n + 1, 0);
  for (const GraphEdge& edge : edges) {
    if (edge.a != edge.b) {
      ++offsets[edge.a + 1];
      ++offsets[edge.b + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  half_edges.resize(offsets[n]);
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const GraphEdge& edge : edges) {
    if (edge.a != edge.b) {
      half_edges[next[edge.a]++] = {edge.b, edge.length};
      half_edges[next[edge.b]++] = {edge.a, edge.length};
    }
  }
}

} // namespace

SurfaceGraph
buildGraph(std::size_t n, const std::vector<GraphEdge>& edges)
{
  std::vector<std::uint32_t> offsets;
  std::vector<HalfEdge> half_edges;
  heartbeat();
  scatterHalfEdges(n, edges, offsets, half_edges);
  heartbeat();

  SurfaceGraph graph;
  graph.offsets.assign(n + 1, 0);
  graph.neighbours.reserve(half_edges.size());
  graph.lengths.reserve(half_edges.size());
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = half_edges.begin() + offsets[v];
    const auto end = half_edges.begin() + offsets[v + 1];
    std::sort(begin, end,
              [](const HalfEdge& x, const HalfEdge& y) { return x.to != y.to ? x.to < y.to : x.length < y.length; });
    for (auto it = begin; it != end; ++it) {
      if (it == begin || it->to != (it - 1)->to) {
        graph.neighbours.push_back(it->to);
        graph.lengths.push_back(it->length);
      }
    }
    graph.offsets[v + 1] = static_cast<std::uint32_t>(graph.neighbours.size());
  }
  return graph;
}

SurfaceGraph
buildMeshGraph(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<GraphEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      edges.push_back({a, b, distance(points[a], points[b])});
    }
  }
  return buildGraph(points.size(), edges);
}

std::size_t
edgeNumber(const SurfaceGraph& graph, Index from, Index to)
{
  const IndexRange ends = graph.neighboursOf(from);
  return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), to) - graph.neighbours.data());
}

float
edgeLength(const SurfaceGraph& graph, Index a, Index b)
{
  const std::size_t edge = edgeNumber(graph, a, b);
  return edge < graph.offsets[a + 1] && graph.neighbours[edge] == b ? graph.lengths[edge]
                                                                    : std::numeric_limits<float>::infinity();
}

bool
areNeighbours(const SurfaceGraph& graph, Index a, Index b)
{
  const IndexRange ends = graph.neighboursOf(a);
  return std::binary_search(ends.begin(), ends.end(), b);
}

Components
connectedComponents(const SurfaceGraph& graph)
{
  Components components;
  components.component_of.assign(graph.size(), no_index);
  std::vector<Index> stack;
  for (std::size_t seed = 0; seed < graph.size(); ++seed) {
    if (components.component_of[seed] != no_index) {
      continue;
    }
    const auto number = static_cast<Index>(components.sizes.size());
    components.component_of[seed] = number;
    stack.assign(1, static_cast<Index>(seed));
    Index size = 0;
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      ++size;
      for (const Index w : graph.neighboursOf(v)) {
        if (components.component_of[w] == no_index) {
          components.component_of[w] = number;
          stack.push_back(w);
        }
      }
    }
    components.sizes.push_back(size);
  }

  std::vector<Index> order(components.sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return components.sizes[a] > components.sizes[b]; });
  std::vector<Index> rank(order.size());
  std::vector<Index> sizes(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<Index>(i);
    sizes[i] = components.sizes[order[i]];
  }
  for (Index& c : components.component_of) {
    c = rank[c];
  }
  components.sizes = std::move(sizes);
  return components;
}

} // namespace symmetry
} // namespace pcl
