#include "base/tangent_frame.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(TangentFrame, CompletesANormalToARightHandedFrame)
{
  // Along each axis, where one of the two vectors to begin with is of no use, and in between.
  for (const Vector3& direction : {Vector3{1, 0, 0}, Vector3{-1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, -1},
                                   Vector3{0.89F, 0.1F, 0.3F}, Vector3{5, 1, 1}, Vector3{-1, 2, 3}}) {
    for (const float steep : {0.6F, 0.9F}) {
      const Vector3 n = normalized(direction);
      const auto [u, v] = tangentFrame(n, steep);
      EXPECT_NEAR(norm(u), 1.0F, 1e-6F);
      EXPECT_NEAR(norm(v), 1.0F, 1e-6F);
      EXPECT_NEAR(dot(u, n), 0.0F, 1e-6F);
      EXPECT_NEAR(dot(u, v), 0.0F, 1e-6F);
      EXPECT_NEAR(distance(cross(u, v), n), 0.0F, 1e-6F);
    }
  }
}

TEST(TangentFrame, BeginsWithTheOtherAxisAboveTheLimit)
{
  const Vector3 n{0.8F, 0.0F, 0.6F};
  EXPECT_EQ(tangentFrame(n, 0.9F).u[0], 0.0F); // at right angles to the x axis
  EXPECT_EQ(tangentFrame(n, 0.6F).u[1], 0.0F); // to the y axis
}

} // namespace
