/** \file
 * \brief Which way is up.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The direction of an axis in which a body stands upright, as nearly as it can be told from its shape.
 *
 * Files have bodies upright along one of their axes, mostly +y or +z. A body stands if its centre is above the places
 * that touch the ground, and on legs if these are off its mirror plane: what lies on its back, or stands on its head or
 * tail, touches the ground in that plane. A body that runs or leaps does so less; the axis that comes nearest is taken.
 * \param[in] points finite
 * \param[in] lateral unit direction from side to side
 * \return perpendicular to \a lateral, of unit length; zero without points, or where all axes are oblique to \a lateral */
Vector3
uprightDirection(const std::vector<Vector3>& points, const Vector3& lateral);

} // namespace symmetry
} // namespace pcl
