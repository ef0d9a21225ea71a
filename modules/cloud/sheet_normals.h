/** \file
 * \brief Normals where sheets of a surface touch or turn sharply.
 */
#pragma once

#include "geodesic/neighbour_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Turns normals that are a blend of two sheets into the normal of the one that the point is on.
 *
 * The plane through all neighbours of a point lies across the sheets where the point has neighbours on two of them, and
 * normals that change little by little from one sheet to the other hide that they meet. Where too few neighbours are
 * near the plane of the given normal, the plane through the point and two of its neighbours that has most of them near it
 * is taken (M. Fischler and R. Bolles: Random sample consensus, 1981; with all pairs instead of random ones) and fitted
 * to these. Then each normal becomes the mean of its own and those of its neighbours that differ little from it, of
 * either sign (bilateral, as S. Fleishman et al.: Bilateral mesh denoising, 2003), so that each sheet has one direction
 * to its end.
 *
 * For points without noise: it makes planes of three points uncertain, and the given normals are better. Cost O(n k)
 * where the points lie in one sheet, O(k^3) for a point between two.
 * \param[in] normals unit length, of either sign */
std::vector<Vector3>
sheetNormals(const std::vector<Vector3>& points,
             const NeighbourLists& neighbours,
             const std::vector<Vector3>& normals,
             unsigned threads);

} // namespace symmetry
} // namespace pcl
