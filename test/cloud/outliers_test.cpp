#include "cloud/clouds.h"
#include "cloud/outliers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<char>
outliersOf(const std::vector<Vector3>& points)
{
  const NeighbourLists lists = nearestNeighbours(points, 10);
  return findOutliers(points, lists, neighbourDistances(points, lists));
}

TEST(Outliers, NeighbourDistancesAreMeans)
{
  NeighbourLists lists;
  lists.k = 2;
  lists.neighbours = {1, 2, 0, no_index, no_index, no_index};
  EXPECT_EQ(neighbourDistances({{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 3.0F, 0.0F}}, lists),
            (std::vector<float>{2.0F, 1.0F, 0.0F}));
}

TEST(Outliers, AreFoundWhereEachHasOthersAround)
{
  // So many in the cube around the sphere that the nearest points of most are outliers, too.
  std::mt19937 random(41);
  std::vector<Vector3> points = sphereCloud(20000, 0.4F);
  const std::size_t surface = points.size();
  std::size_t far = 0;
  while (points.size() < surface + 1000) {
    points.push_back({evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F)});
  }
  const std::vector<char> outlier = outliersOf(points);
  EXPECT_EQ(std::count(outlier.begin(), outlier.begin() + static_cast<std::ptrdiff_t>(surface), 1), 0);
  std::size_t found = 0;
  for (std::size_t v = surface; v < points.size(); ++v) {
    if (std::abs(norm(points[v]) - 0.4F) > 0.05F) {
      ++far;
      found += static_cast<std::size_t>(outlier[v]);
    }
  }
  EXPECT_GT(far, 500U);
  EXPECT_GE(100 * found, 98 * far);
}

TEST(Outliers, AreNoneOnASurfaceWithATenthOfTheDensity)
{
  std::vector<Vector3> points = sphereCloud(20000, 0.3F, {-0.5F, 0.0F, 0.0F});
  const std::vector<Vector3> coarse = sphereCloud(1500, 0.3F, {0.5F, 0.0F, 0.0F});
  points.insert(points.end(), coarse.begin(), coarse.end());
  const std::vector<char> outlier = outliersOf(points);
  EXPECT_EQ(std::count(outlier.begin(), outlier.end(), 1), 0);
}

TEST(Outliers, OfANoisyCloudAreOnlyThoseAlone)
{
  // A sparse part that noise makes as thick as wide.
  std::vector<Vector3> points = sphereCloud(20000, 0.3F, {-0.5F, 0.0F, 0.0F});
  const std::vector<Vector3> coarse = sphereCloud(1500, 0.3F, {0.5F, 0.0F, 0.0F});
  points.insert(points.end(), coarse.begin(), coarse.end());
  const std::vector<char> outlier = outliersOf(noisy(points, 0.015F, 42));
  EXPECT_LT(std::count(outlier.begin(), outlier.end(), 1), 15);
}

} // namespace
