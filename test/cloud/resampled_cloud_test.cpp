#include "cloud/resampled_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(ResampledCloud, IsTheCloudWhereThatIsCleanAndSmall)
{
  const std::vector<Vector3> points = sphereCloud(3000, sphere_radius);
  const ResampledCloud cloud = resampledCloud(points);
  EXPECT_EQ(cloud.points, points);
  EXPECT_EQ(unrepresented(cloud), 0U);
  EXPECT_EQ(cloud.smoothing_radius, 0.0F);
  expectConsistent(cloud, points.size());
}

TEST(ResampledCloud, HasNoOutliers)
{
  const std::vector<Vector3> sphere = sphereCloud(3000, sphere_radius);
  std::vector<Vector3> points = sphere;
  // Not at the end, so that all numbers behind them change.
  const std::vector<Vector3> far{
      {0.5F, 0.5F, 0.5F}, {-0.5F, 0.5F, -0.4F}, {0.0F, 0.0F, 0.0F}, {0.02F, 0.0F, 0.0F}}; // two of them a pair
  points.insert(points.begin() + 1000, far.begin(), far.end());
  const ResampledCloud cloud = resampledCloud(points);
  EXPECT_EQ(cloud.points, sphere);
  EXPECT_EQ(unrepresented(cloud), far.size());
  expectConsistent(cloud, points.size());
  for (std::size_t i = 0; i < far.size(); ++i) {
    EXPECT_EQ(cloud.representatives[1000 + i], no_index);
  }
  EXPECT_EQ(cloud.representatives[999], 999);
  EXPECT_EQ(cloud.representatives[1004], 1000);
}

TEST(ResampledCloud, HasNoPointsBesideTheSurface)
{
  const std::vector<Vector3> sphere = sphereCloud(3000, sphere_radius); // about 0.026 apart
  std::vector<Vector3> points = sphere;
  for (std::size_t v = 0; v < sphere.size(); v += 150) {
    points.push_back(((sphere_radius + 0.05F) / sphere_radius) * sphere[v]); // as close as neighbours are
  }
  const ResampledCloud cloud = resampledCloud(points);
  expectConsistent(cloud, points.size());
  EXPECT_EQ(cloud.points, sphere);
}

TEST(ResampledCloud, StandsForTheTipOfASparseSpike)
{
  std::vector<Vector3> points = sphereCloud(3000, sphere_radius);
  const auto n = static_cast<Index>(points.size());
  for (const auto& [x, y] : {std::pair(0.01F, 0.0F), std::pair(-0.01F, 0.01F), std::pair(-0.01F, -0.01F)}) {
    points.push_back({x, y, sphere_radius + 0.05F}); // n to n + 2: as far as some gaps are wide
  }
  points.push_back({0.0F, 0.0F, sphere_radius + 0.13F});  // n + 3: alone, but not far from those
  points.push_back({0.0F, 0.0F, -sphere_radius - 0.13F}); // n + 4: alone
  const ResampledCloud cloud = resampledCloud(points);
  expectConsistent(cloud, points.size());
  EXPECT_EQ(cloud.points.size(), static_cast<std::size_t>(n) + 3);
  EXPECT_GE(cloud.representatives[n + 3], cloud.representatives[n]);
  EXPECT_EQ(cloud.representatives[n + 4], no_index);
}

TEST(ResampledCloud, IsNoLargerThanAskedFor)
{
  const std::vector<Vector3> points = sphereCloud(12000, sphere_radius);
  constexpr std::size_t most = 1000;
  const ResampledCloud cloud = resampledCloud(points, most);
  EXPECT_LE(cloud.points.size(), most);
  EXPECT_GT(cloud.points.size(), most / 3);
  EXPECT_EQ(unrepresented(cloud), 0U);
  EXPECT_EQ(cloud.smoothing_radius, 0.0F);
  expectConsistent(cloud, points.size());
  for (std::size_t w = 0; w < cloud.points.size(); ++w) {
    ASSERT_EQ(cloud.points[w], points[cloud.original[w]]);
  }
  // The nearest one by brute force, and none is far: 1000 points on this sphere are 0.045 apart.
  for (std::size_t v = 0; v < points.size(); ++v) {
    float least = std::numeric_limits<float>::infinity();
    for (const Vector3& w : cloud.points) {
      least = std::min(least, distance(points[v], w));
    }
    ASSERT_FLOAT_EQ(distance(points[v], cloud.points[cloud.representatives[v]]), least);
    ASSERT_LT(least, 0.09F);
  }
}

/** Squares of distances below 1e-22 are 0: no spacing at all, of points none of which come twice. */
TEST(ResampledCloud, IsNoLargerThanAskedForWherePointsAreAsGoodAsOne)
{
  std::mt19937 random(4);
  std::vector<Vector3> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back({i % 2 == 0 ? 0.0F : 1.0F, evenly(random, 0.0F, 1e-25F), evenly(random, 0.0F, 1e-25F)});
  }
  const ResampledCloud cloud = resampleCloud(points, nearestNeighbours(points, 10), 100, NoiseInterpretation::Close);
  EXPECT_LE(cloud.points.size(), 100U);
}

TEST(ResampledCloud, UnevenDensityIsNoOutlier)
{
  const std::vector<Vector3> clean = unevenSphere(5000);
  const ResampledCloud cloud = resampledCloud(clean);
  EXPECT_EQ(cloud.smoothing_radius, 0.0F);
  EXPECT_LE(unrepresented(cloud), 3U);
  EXPECT_EQ(cloud.points.size(), clean.size() - unrepresented(cloud));
}

TEST(ResampledCloud, OfNextToNothing)
{
  EXPECT_TRUE(resampledCloud({}).points.empty());
  EXPECT_EQ(resampledCloud({{0.1F, 0.2F, 0.3F}}).points.size(), 1U);
  const std::vector<Vector3> same(20, Vector3{0.1F, 0.2F, 0.3F});
  const ResampledCloud cloud = resampledCloud(same);
  EXPECT_EQ(unrepresented(cloud), 0U);
  expectConsistent(cloud, same.size());
}

} // namespace
