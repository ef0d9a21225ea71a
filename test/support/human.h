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

} // namespace test
} // namespace symmetry
} // namespace pcl
