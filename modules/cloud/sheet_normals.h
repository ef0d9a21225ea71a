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
 * near that plane, it is turned about the point to the sheet nearest to it: fitted again, three times, with weights
 * that fall with the distance from it (iteratively reweighted least squares, P. Holland and R. Welsch, 1977
 * \cite holland1977robust). Then each normal becomes the mean of its own and those of its neighbours that differ little
 * from it, of either sign (bilateral, as S. Fleishman et al.: Bilateral mesh denoising, 2003
 * \cite fleishman2003bilateral), so that each sheet has one direction to its end.
 *
 * For points without noise: a plane that is held by one point follows its noise. Cost O(n k).
 * \param[in] normals unit length, of either sign */
std::vector<Vector3>
sheetNormals(const std::vector<Vector3>& points, const NeighbourLists& neighbours, const std::vector<Vector3>& normals);

} // namespace symmetry
} // namespace pcl
