#include "base/vector_math.h"
#include "neighbour_search.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::symmetry;

namespace {

std::vector<Vector3>
randomPoints(std::size_t count)
{
  std::mt19937 random(3);
  const auto coordinate = [&random] {
    return static_cast<float>(random() % 100000U) / 1000.0F;
  };
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    points.push_back({x, y, coordinate()});
  }
  return points;
}

TEST(NeighbourSearch, FindsTheNearestPointsInOrder)
{
  const std::vector<Vector3> points = randomPoints(700);
  const NeighbourLists lists = test::withThreads(2, [&] { return searchByKdTree(points, 6); });
  ASSERT_EQ(lists.k, 6U);
  ASSERT_EQ(lists.neighbours.size(), 6 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<float> all;
    for (const Vector3& p : points) {
      all.push_back(distance(p, points[i]));
    }
    std::sort(all.begin(), all.end());
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_FLOAT_EQ(distance(points[lists.neighbours[6 * i + j]], points[i]), all[j]);
    }
  }
}

TEST(NeighbourSearch, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<Vector3> points = randomPoints(2000);
  EXPECT_EQ(searchByKdTree(points, 8).neighbours,
            test::withThreads(5, [&] { return searchByKdTree(points, 8); }).neighbours);
}

TEST(NeighbourSearch, MoreNeighboursThanPointsAreAllOfThem)
{
  const NeighbourLists lists = searchByKdTree(randomPoints(4), 10);
  EXPECT_EQ(lists.k, 4U);
  EXPECT_EQ(lists.neighbours.size(), 16U);
  EXPECT_EQ(std::count(lists.neighbours.begin(), lists.neighbours.end(), no_index), 0);
  EXPECT_TRUE(searchByKdTree({}, 10).neighbours.empty());
}

} // namespace
