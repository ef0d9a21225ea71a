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

} // namespace symmetry
} // namespace pcl
