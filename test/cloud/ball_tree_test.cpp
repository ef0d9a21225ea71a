#include "base/vector_math.h"
#include "cloud/ball_tree.h"
#include "cloud/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Most of them next to each other, a few far away and large. */
struct UnevenBalls {
  std::vector<Vector3> centres;
  std::vector<float> radii;

  explicit UnevenBalls(std::size_t count)
  {
    std::mt19937 random(4);
    for (std::size_t i = 0; i < count; ++i) {
      const float size = i % 10 == 0 ? 1.0F : 0.01F;
      centres.push_back({evenly(random, -size, size), evenly(random, -size, size), evenly(random, -size, size)});
      radii.push_back(evenly(random, 0.0F, 0.2F * size));
    }
  }
};

TEST(BallTree, VisitsAllBallsThatReachAPlace)
{
  const UnevenBalls balls(1000);
  const BallTree tree(balls.centres, balls.radii);
  for (const Vector3& place : {Vector3{0, 0, 0}, Vector3{0.5F, 0.5F, 0}, Vector3{0.02F, 0, 0}, Vector3{3, 3, 3}}) {
    std::set<Index> visited;
    tree.visitNearest(
        place, [](float radius) { return radius; }, [&visited](Index i) { EXPECT_TRUE(visited.insert(i).second); });
    for (std::size_t i = 0; i < balls.centres.size(); ++i) {
      if (distance(balls.centres[i], place) <= balls.radii[i]) {
        EXPECT_EQ(visited.count(static_cast<Index>(i)), 1U);
      }
    }
    EXPECT_LT(visited.size(), balls.centres.size());
  }
}

TEST(BallTree, FindsTheNearestCentreWithFewVisits)
{
  const UnevenBalls balls(20000);
  const BallTree tree(balls.centres, std::vector<float>(balls.centres.size(), 0.0F));
  std::size_t visits = 0;
  for (std::size_t v = 0; v < balls.centres.size(); v += 199) {
    const Vector3 place = 1.01F * balls.centres[v];
    float least = std::numeric_limits<float>::infinity();
    tree.visitNearest(
        place, [&least](float) { return least; },
        [&](Index i) {
          ++visits;
          least = std::min(least, distance(balls.centres[i], place));
        });
    float expected = std::numeric_limits<float>::infinity();
    for (const Vector3& centre : balls.centres) {
      expected = std::min(expected, distance(centre, place));
    }
    EXPECT_EQ(least, expected);
  }
  EXPECT_LT(visits, 101U * 60U);
}

TEST(BallTree, OfNothingVisitsNothing)
{
  const BallTree tree({}, {});
  tree.visitNearest(
      {0, 0, 0}, [](float) { return 1.0F; }, [](Index) { FAIL(); });
}

TEST(BallTree, OfEqualPlacesIsNotDeeperThanOfOthers)
{
  const std::vector<Vector3> centres(5000, {1.0F, 2.0F, 3.0F});
  std::size_t visits = 0;
  BallTree(centres, std::vector<float>(centres.size(), 0.5F))
      .visitNearest(
          {1, 2, 3}, [](float radius) { return radius; }, [&visits](Index) { ++visits; });
  EXPECT_EQ(visits, centres.size());
}

} // namespace
