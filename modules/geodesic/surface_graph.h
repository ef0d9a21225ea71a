/** \file
 * \brief Graph of a surface in compressed sparse row form.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Undirected weighted graph: the edges of vertex v are entries [offsets[v], offsets[v + 1]). */
struct SurfaceGraph {
  std::vector<std::uint32_t> offsets{0}; ///< n + 1
  std::vector<Index> neighbours;         ///< ascending per vertex, without the vertex itself, without duplicates
  std::vector<float> lengths;            ///< edge lengths, finite, not negative

  std::size_t
  size() const
  {
    return offsets.size() - 1;
  }
};

/** \brief One undirected edge, given in either direction. */
struct GraphEdge {
  Index a = no_index;
  Index b = no_index;
  float length = 0.0F;
};

/** \brief Symmetric graph of n vertices from edges: self-loops are dropped, of parallel edges the shortest is kept. */
SurfaceGraph
buildGraph(std::size_t n, const std::vector<GraphEdge>& edges);

/** \brief Graph of a mesh: one edge per side of a triangle, of Euclidean length. Cost O(m log m). */
SurfaceGraph
buildMeshGraph(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles);

/** \brief Entry of the edge from one vertex to a neighbour of it. Cost O(log degree). */
std::size_t
edgeNumber(const SurfaceGraph& graph, Index from, Index to);

/** \brief Length of the edge between two vertices; infinity where there is none. Cost O(log degree). */
float
edgeLength(const SurfaceGraph& graph, Index a, Index b);

/** \brief Whether an edge joins two vertices. Cost O(log degree). */
bool
areNeighbours(const SurfaceGraph& graph, Index a, Index b);

/** \brief Connected components: the number of each vertex's component, ordered by falling size (ties: the one with the
 * lowest vertex first), and their sizes. */
struct Components {
  std::vector<Index> component_of;
  std::vector<Index> sizes;
};

Components
connectedComponents(const SurfaceGraph& graph);

} // namespace symmetry
} // namespace pcl
