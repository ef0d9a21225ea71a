/** \file
 * \brief A four-legged animal in one pose, for the tests of steps in the middle of the method.
 */
#pragma once

#include "support/coarse_body.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Made once. */
inline const CoarseBody&
quadruped()
{
  static const CoarseBody body = coarseBody(Body::Quadruped, 0.3);
  return body;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
