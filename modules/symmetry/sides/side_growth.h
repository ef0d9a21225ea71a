/** \file
 * \brief Sides of all points, grown from those whose side is clear.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Which side every point is on, from a function that is clear about most of them.
 *
 * Where it is not, a point takes the side of a neighbour and its partner the other one, the points that lie farthest
 * from their partners first and against the sign of the function late: a watershed by flooding (F. Meyer: Topographic
 * distance and watershed lines, 1994 \cite meyer1994topographic). The two sides meet where points are nearest to their
 * partners, on parts however thin.
 * \param[in] graph of the surface
 * \param[in] partners of every point
 * \param[in] ways distance of every point from its partner
 * \param[in] side_function of unit mean square: its sign is the side, clear where its size is about 1
 * \return the ways with the sign of the side, which is zero for what no side reaches. Cost O(n log n). */
std::vector<float>
growSides(const SurfaceGraph& graph,
          const std::vector<Index>& partners,
          const std::vector<float>& ways,
          const std::vector<float>& side_function);

} // namespace symmetry
} // namespace pcl
