#include "base/vector_math.h"
#include "neighbour_search.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

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

// Of points equally far others would do as well, but callers who hand over PCL's search are to get the same map.
TEST(NeighbourSearch, AnswersAsPclDoes)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<Vector3> points;
  for (int i = 0; i < 1000; ++i) { // a lattice: most distances come several times
    points.push_back({static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 100)});
    cloud->push_back({points.back()[0], points.back()[1], points.back()[2]});
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  for (const std::size_t k : {1U, 8U, 250U, 251U, 256U}) { // FLANN keeps more than 250 another way
    const NeighbourLists lists = test::withThreads(3, [&] { return searchByKdTree(points, static_cast<int>(k)); });
    ASSERT_EQ(lists.k, k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      pcl::Indices expected;
      std::vector<float> squared_distances;
      tree.nearestKSearch((*cloud)[i], static_cast<unsigned>(k), expected, squared_distances);
      const auto first = lists.neighbours.begin() + static_cast<std::ptrdiff_t>(i * k);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), first)) << "neighbours of " << i << ", k " << k;
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
