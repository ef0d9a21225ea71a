/** \file
 * \brief An order of the vertices of a graph in which shortest paths are cheap to eliminate.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A graph taken apart by small separators (A. George: Nested dissection of a regular finite element mesh. SIAM
 * J. Numer. Anal. 10(2), 1973 \cite george1973nested).
 *
 * Node x of the tree owns the vertices at positions [begin, end) of \a order. No edge joins two vertices of different
 * nodes unless one node is an ancestor of the other.
 */
struct Dissection {
  struct Node {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::int32_t parent = -1;            ///< -1: the root
    std::int32_t children[2] = {-1, -1}; ///< -1: none
  };

  std::vector<Node> nodes;  ///< children before parents; positions rise with the number of the node
  std::vector<Index> order; ///< vertex at each position
};

/** \brief Cuts the graph in two until no piece has more than \a largest_leaf vertices.
 *
 * A piece is cut across the principal direction of the numbers of edges to a few vertices far from each other, so that
 * no positions are needed and a folded surface is taken apart as if it were straight: where the border is short and
 * each part has at least a third of the vertices. The separator is the smallest set of vertices that touches all edges
 * across the cut. Small separators are what surfaces have; any graph may
 * be given. Cost O(n log n). The result does not depend on
 * the number of threads.
 */
Dissection
dissect(const SurfaceGraph& graph, std::size_t largest_leaf);

} // namespace symmetry
} // namespace pcl
