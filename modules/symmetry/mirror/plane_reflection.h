/** \file
 * \brief A plane in space and the reflection in it.
 */
#pragma once

#include "base/vector_math.h"

namespace pcl {
namespace symmetry {

/** \brief The points p with dot (normal, p) = offset. */
struct PlaneReflection {
  Vector3 normal{1.0F, 0.0F, 0.0F}; ///< unit length
  float offset = 0.0F;

  /** \brief Signed distance from the plane, positive where the normal points. */
  float
  height(const Vector3& place) const
  {
    return dot(normal, place) - offset;
  }

  /** \brief The mirror image of a place. */
  Vector3
  image(const Vector3& place) const
  {
    return place - (2.0F * height(place)) * normal;
  }

  /** \brief The mirror image of a direction. */
  Vector3
  turned(const Vector3& direction) const
  {
    return direction - (2.0F * dot(normal, direction)) * normal;
  }
};

} // namespace symmetry
} // namespace pcl
