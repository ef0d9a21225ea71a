/** \file
 * \brief The plane that a map comes nearest to being the reflection in.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Fits a plane so that the reflection in it carries points as near to their partners as it can, in the sense of
 * least squares.
 *
 * With p and q the points and their partners less their means, the normal is the eigenvector of the lowest eigenvalue of
 * the sum of p q^T + q p^T; the plane contains the middle of the two means.
 * \param[in] points in any unit
 * \param[in] partners one per point, -1 where there is none
 * \param[in] sides one per point: the normal points to the source side
 * \return in the unit of the points; a normal of zero length where no point has a partner. Cost O(n). */
MirrorPlane
fitMirrorPlane(const std::vector<Vector3>& points, const std::vector<Index>& partners, const std::vector<Side>& sides);

/** \brief The same plane where a place is scale * p + shift. */
MirrorPlane
movedPlane(const MirrorPlane& plane, double scale, const std::array<double, 3>& shift);

} // namespace symmetry
} // namespace pcl
