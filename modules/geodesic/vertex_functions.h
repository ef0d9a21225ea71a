/** \file
 * \brief Functions on the vertices of a surface graph: smoothing and local maxima over 1-rings.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Mean of each vertex's value and its neighbours' values, \a rounds times. */
std::vector<float>
smoothOverRings(const SurfaceGraph& graph, std::vector<float> values, int rounds);

/** \brief Vertices whose value is larger than that of every neighbour, ascending.
 *
 * On a plateau (equal neighbours) the lowest vertex counts as the larger one. Vertices without neighbours are none.
 */
std::vector<Index>
localMaxima(const SurfaceGraph& graph, const std::vector<float>& values);

/** \brief Those of some vertices that have no vertex of a larger value among them closer than \a separation.
 *
 * Taken greedily from the largest value down (ties: the lowest vertex first); a vertex that was not taken suppresses
 * none.
 * \return in the order taken
 */
std::vector<Index>
separated(const SurfaceGraph& graph,
          const std::vector<Index>& vertices,
          const std::vector<float>& values,
          float separation);

} // namespace symmetry
} // namespace pcl
