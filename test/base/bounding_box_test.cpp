#include "base/bounding_box.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(BoundingBox, IsTheSmallestAroundItsPoints)
{
  const BoundingBox box = boundingBox({{1, -2, 3}, {-1, 5, 3}, {0, 0, 15}});
  EXPECT_EQ(box.low, (Vector3{-1, -2, 3}));
  EXPECT_EQ(box.high, (Vector3{1, 5, 15}));
  EXPECT_EQ(box.longestSide(), 12.0);
  EXPECT_DOUBLE_EQ(box.diagonal(), std::sqrt(4.0 + 49.0 + 144.0));
  EXPECT_EQ(box.centre(), (std::array<double, 3>{0.0, 1.5, 9.0}));
}

TEST(BoundingBox, MeasuresHowFarAPointIsOutside)
{
  const BoundingBox box = boundingBox({{0, 0, 0}, {2, 4, 6}});
  EXPECT_EQ(box.distanceTo({1, 1, 9}), 3.0);
  EXPECT_EQ(box.distanceTo({-1, 9, 3}), 5.0); // along one axis, not straight
  EXPECT_EQ(box.distanceTo({2, 4, 6}), 0.0);
  EXPECT_EQ(box.distanceTo({1, 1, 1}), -1.0);
  EXPECT_EQ(box.straightDistanceTo({5, -4, 3}), 5.0);
  EXPECT_EQ(box.straightDistanceTo({3, 6, 8}), 3.0);
  EXPECT_EQ(box.straightDistanceTo({1, 1, 1}), 0.0);
}

TEST(BoundingBox, OfNothingIsNotAPoint)
{
  EXPECT_LT(boundingBox({}).longestSide(), 0.0);
  EXPECT_EQ(boundingBox({}).diagonal(), 0.0);
  EXPECT_EQ(boundingBox({{7, 7, 7}}).longestSide(), 0.0);
}

TEST(BoundingBox, KeepsItsDigitsWhereCoordinatesAreHuge)
{
  EXPECT_EQ(boundingBox({{-3e38F, 0, 0}, {3e38F, 0, 0}}).longestSide(), 2.0 * double{3e38F});
}

} // namespace
