/** \file
 * \brief A body whose sides are known, for the tests of sides and limbs.
 */
#pragma once

#include "support/coarse_body.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief In the usual pose. */
inline const CoarseBody&
human()
{
  static const CoarseBody body = coarseBody(Body::Human, 1.0);
  return body;
}

/** \brief On which side of the plane x = 0 the sample of a landmark lies in the rest pose: -1, 0 or 1. Models of one
 * body have the same vertices whatever the pose. */
inline int
trueSide(Index landmark)
{
  static const Model at_rest = body(Body::Human, 0.0);
  const float x = at_rest.surface.points[human().coarse.cells.vertices[landmark]][0];
  return x > 0.02F ? 1 : x < -0.02F ? -1 : 0;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
