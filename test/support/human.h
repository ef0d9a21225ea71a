/** \file
 * \brief A human in a pose with its coarse stand-ins, for the tests of a whole program.
 */
#pragma once

#include "support/coarse_body.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Made once. */
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
