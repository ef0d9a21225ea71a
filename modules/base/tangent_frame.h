/** \file
 * \brief Axes of a tangent plane.
 */
#pragma once

#include "base/vector_math.h"

#include <cmath>

namespace pcl {
namespace symmetry {

/** \brief Two unit vectors that complete a normal to a right-handed orthonormal frame. */
struct TangentFrame {
  Vector3 u;
  Vector3 v;
};

/** \brief Some frame of the plane across a unit normal; the same normal always gives the same.
 * \param[in] steep from which component along x on the frame begins with the y axis instead of the x axis: either is
 * far enough from the normal anywhere between 0.1 and 0.99, the value only decides how the frame lies in its plane */
inline TangentFrame
tangentFrame(const Vector3& normal, float steep = 0.9F)
{
  const Vector3 across = std::abs(normal[0]) < steep ? Vector3{1.0F, 0.0F, 0.0F} : Vector3{0.0F, 1.0F, 0.0F};
  const Vector3 u = normalized(cross(normal, across));
  return {u, cross(normal, u)};
}

} // namespace symmetry
} // namespace pcl
