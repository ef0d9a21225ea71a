/** \file
 * \brief Graph of a surface in compressed sparse row form.
 */
#pragma once

#include "base/index_range.h"

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Where an edge of a vertex leads, and how long it is. */
struct EdgeEnd {
  Index vertex = no_index;
  float length = 0.0F;
};

/** \brief The edges of one vertex of a graph that outlives the range, in the order of the vertices that they lead to:
 * for (const auto [neighbour, length] : graph.edges (v)). */
class EdgeRange {
public:
  class Iterator {
  public:
    Iterator(const Index* vertex, const float* length) : vertex_(vertex), length_(length)
    {
    }

    EdgeEnd
    operator*() const
    {
      return {*vertex_, *length_};
    }

    Iterator&
    operator++()
    {
      ++vertex_;
      ++length_;
      return *this;
    }

    bool
    operator!=(const Iterator& other) const
    {
      return vertex_ != other.vertex_;
    }

  private:
    const Index* vertex_;
    const float* length_;
  };

  EdgeRange(IndexRange vertices, const float* lengths) : vertices_(vertices), lengths_(lengths)
  {
  }

  Iterator
  begin() const
  {
    return {vertices_.begin(), lengths_};
  }

  Iterator
  end() const
  {
    return {vertices_.end(), lengths_ + vertices_.size()};
  }

private:
  IndexRange vertices_;
  const float* lengths_;
};

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

  /** \brief The vertices that edges lead to from one. */
  IndexRange
  neighboursOf(std::size_t v) const
  {
    return {neighbours.data() + offsets[v], neighbours.data() + offsets[v + 1]};
  }

  /** \brief The same with the lengths of the edges. */
  EdgeRange
  edges(std::size_t v) const
  {
    return {neighboursOf(v), lengths.data() + offsets[v]};
  }

  /** \brief Number of edges of a vertex. */
  std::size_t
  degree(std::size_t v) const
  {
    return offsets[v + 1] - offsets[v];
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
