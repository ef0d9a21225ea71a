#include "base/centroid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

TEST(Centroid, IsTheMean)
{
  EXPECT_EQ(centroid({{0, 0, 0}, {4, 2, -6}}), (Vector3{2, 1, -3}));
  EXPECT_TRUE(std::isnan(centroid({})[0]));
}

TEST(Centroid, OfManyPointsIsSummedUpInDouble)
{
  const std::vector<Vector3> points(1U << 20U, Vector3{0.1F, 0.7F, 1000.1F});
  EXPECT_EQ(centroid(points), points.front());
}

TEST(FarthestFromCentroid, IsTheFirstOfThoseEquallyFar)
{
  EXPECT_EQ(farthestFromCentroid({{0, 0, 0}, {1, 0, 0}, {9, 0, 0}, {2, 0, 0}}), 2);
  EXPECT_EQ(farthestFromCentroid({{0, 0, 0}, {0, 1, 0}, {0, -1, 0}}), 1);
  EXPECT_EQ(farthestFromCentroid({}), 0);
}

} // namespace
