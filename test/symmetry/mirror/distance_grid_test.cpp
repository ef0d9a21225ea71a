#include "base/vector_math.h"
#include "support/shapes.h"
#include "symmetry/mirror/distance_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(DistanceGrid, AgreesWithTheDistanceToTheNearestPointWithinTwoCubes)
{
  const std::vector<Vector3> points = scaled(sphereMesh(3), {1.0F, 0.5F, 0.3F}).points;
  constexpr std::size_t cells = 40;
  const DistanceGrid grid(points, cells);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> coordinate(-1.5F, 1.5F);
  for (int i = 0; i < 500; ++i) {
    const Vector3 place{coordinate(random), coordinate(random), coordinate(random)};
    float nearest = 10.0F;
    for (const Vector3& p : points) {
      nearest = std::min(nearest, distance(p, place));
    }
    // Beyond the grid the way to it and on from there is at most twice as long as the straight one.
    EXPECT_GE(grid.at(place), nearest - 3.0F * 2.0F / cells);
    EXPECT_LE(grid.at(place), 2.0F * nearest + 3.0F * 2.0F / cells);
  }
}

TEST(DistanceGrid, IsZeroAtThePointsAndTakesASingleOne)
{
  const DistanceGrid one({{1.0F, 2.0F, 3.0F}}, 10);
  EXPECT_EQ(one.at({1.0F, 2.0F, 3.0F}), 0.0F);
  EXPECT_NEAR(one.at({5.0F, 2.0F, 3.0F}), 4.0F, 1.1F);
  const std::vector<Vector3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const DistanceGrid grid(line, 8);
  for (const Vector3& p : line) {
    EXPECT_EQ(grid.at(p), 0.0F);
  }
}

} // namespace
