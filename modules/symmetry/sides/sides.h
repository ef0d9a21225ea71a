/** \file
 * \brief Which side of the symmetry axis each vertex lies on (paper, section 3.3, side decision).
 */
#pragma once

#include "geodesic/shortest_paths.h"
#include "geodesic/surface_graph.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Votes of the matched pairs: (pairs whose source end is nearer - pairs whose target end is) / pairs.
 *
 * Where the vote is a draw the mean relative difference of the distances decides; it weighs less than half a vote. A
 * pair one of whose ends cannot be reached does not vote.
 * \param[in] source_fields row i: distances from the source end of pair i
 * \param[in] target_fields row i: distances from its target end
 * \return per vertex a value in [-1, 1]: positive on the source side, negative on the target side
 */
std::vector<float>
sideFunction(const DistanceFields& source_fields, const DistanceFields& target_fields);

/** \brief The side function without zeros: they take the sign of most of their neighbours, the source side where they are
 * as many. It is the sign that labels a vertex and that the axis runs between.
 */
std::vector<float>
withoutZeros(const SurfaceGraph& graph, const std::vector<float>& side_function);

/** \brief The side function without zeros and with the sign of isolated specks turned.
 *
 * A speck is a connected patch of one sign that holds less than 2 % of the vertices and is not the largest patch of its
 * sign.
 */
std::vector<float>
absorbSpecks(const SurfaceGraph& graph, const std::vector<float>& side_function);

/** \brief Source or target by the sign of the side function.
 * \param[in] side_function no value is zero
 */
std::vector<Side>
labelSides(const std::vector<float>& side_function);

/** \brief Labels the points on the axis or next to it: a line one point wide, alike on both sides.
 *
 * Of every edge from one side to the other the end with the smaller value is on the axis. So are the partners of such
 * points, and points whose partners are, as long as they have a neighbour on the other side.
 * \param[in] side_function no value is zero
 * \param[in] partners one per point, -1 where there is none; may be empty
 * \param[in,out] sides as labelSides () returns them
 */
void
markAxis(const SurfaceGraph& graph,
         const std::vector<float>& side_function,
         const std::vector<Index>& partners,
         std::vector<Side>& sides);

} // namespace symmetry
} // namespace pcl
