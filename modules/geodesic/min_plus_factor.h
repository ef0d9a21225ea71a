/** \file
 * \brief Shortest paths from many sources by elimination instead of search.
 */
#pragma once

#include "base/large_memory.h"
#include "geodesic/nested_dissection.h"
#include "geodesic/surface_graph.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Factor of the matrix of edge lengths over the (min, +) semiring: a multifrontal Cholesky factorization whose
 * arithmetic is min and + (B. Carre: An algebra for network routing problems. IMA J. Appl. Math. 7(3), 1971
 * \cite carre1971algebra), in the order of a nested dissection \cite george1973nested.
 *
 * From the leaves of the dissection up, every node closes the distances among its own vertices, derives those to its
 * boundary (the vertices above it that its subtree touches) and hands the distances within its boundary up. A field is
 * then two sweeps: up from the source to the root, and down over all nodes. Distances are those of Dijkstra's algorithm
 * but for rounding, since the sums are formed in another order: the same for every number of threads and every
 * instruction set. On surfaces of 10^4 to 10^5 vertices a field costs about 8 times less than a search, all that comes
 * before it as much as 20 to 30 searches, and the factor takes about 130 floats a vertex.
 */
class MinPlusFactor {
public:
  /** \brief What it would take to factorize; found without doing it. */
  struct Cost {
    double factor = 0.0; ///< minima of sums
    double field = 0.0;  ///< the same, per source
  };

  /** \brief Dissects the graph and finds the boundary of every node.
   * \param[in] graph referred to, not copied
   * \param[in] maximum_field_cost the analysis ends early, as not feasible (), when a field would cost more */
  MinPlusFactor(const SurfaceGraph& graph, double maximum_field_cost);

  bool
  feasible() const
  {
    return feasible_;
  }

  const Cost&
  cost() const
  {
    return cost_;
  }

  /** \brief Computes the factor; the graph must be feasible (). */
  void
  factorize();

  /** \brief Distances from every source to every vertex.
   * \param[out] rows sources x graph.size () values */
  void
  fields(const std::vector<Index>& sources, float* rows) const;

private:
  /** Matrices are row-major; their strides are rounded up to whole blocks of kernel_lanes, filled up with infinity. */
  struct Front {
    std::size_t boundary = 0; ///< where its part of boundaries_ begins
    std::size_t boundary_count = 0;
    std::size_t own_stride = 0;
    std::size_t boundary_stride = 0;
    std::size_t to_boundary = 0; ///< where its part of to_boundary_ begins
    std::size_t closure = 0;     ///< where its part of closure_ begins
    FloatBlock update;           ///< boundary x boundary, upper triangle; until the parent has taken it over
  };

  /** An edge from a lower position. */
  struct Edge {
    std::uint32_t position;
    float length;
  };

  class BoundaryFinder;
  struct FrontScratch;
  class FieldBatch;

  void
  sortEdges();

  bool
  findBoundaries(double maximum_field_cost);

  void
  eliminate(std::size_t node, FrontScratch& scratch);

  void
  assemble(std::size_t node, FrontScratch& scratch);

  void
  addUpdate(std::size_t child, std::size_t node, FrontScratch& scratch);

  /** Vertices of a node and all below it. */
  std::size_t
  subtreeSize(std::size_t node) const;

  std::size_t
  ownCount(std::size_t node) const
  {
    return dissection_.nodes[node].end - dissection_.nodes[node].begin;
  }

  /** Positions of the vertices in the boundary of a node, rising. */
  const std::uint32_t*
  boundary(std::size_t node) const
  {
    return boundaries_.data() + fronts_[node].boundary;
  }

  float*
  closure(std::size_t node) const
  {
    return closure_.data() + fronts_[node].closure;
  }

  float*
  toBoundary(std::size_t node) const
  {
    return to_boundary_.data() + fronts_[node].to_boundary;
  }

  const SurfaceGraph& graph_;
  Dissection dissection_;
  std::vector<std::uint32_t> position_;   ///< of every vertex
  std::vector<std::uint32_t> node_at_;    ///< node that owns each position
  std::vector<std::uint32_t> edge_begin_; ///< of every position: where its part of edges_ begins
  std::vector<Edge> edges_;
  std::vector<Front> fronts_;
  std::vector<std::uint32_t> boundaries_;
  std::size_t closure_size_ = 0;
  std::size_t to_boundary_size_ = 0;
  /** Of every node, own x own: distances among its vertices within its subtree. */
  FloatBlock closure_;
  /** Of every node, boundary x own: distances from its boundary to its vertices within its subtree. One block, in the
   * order in which a field runs through it. */
  FloatBlock to_boundary_;
  Cost cost_;
  bool feasible_ = false;
};

} // namespace symmetry
} // namespace pcl
