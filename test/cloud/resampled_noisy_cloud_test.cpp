// What resampled_cloud.h makes of noise, and of sheets that noise has merged.
#include "cloud/resampled_clouds.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(ResampledNoisyCloud, LiesOnTheSurfaceThatNoiseHides)
{
  const std::vector<Vector3> points = noisy(sphereCloud(20000, sphere_radius), 0.01F, 5);
  const ResampledCloud cloud = resampledCloud(points);
  EXPECT_GT(cloud.smoothing_radius, 0.02F); // of more than the noise
  EXPECT_LT(cloud.smoothing_radius, 0.2F);  // and of less than the sphere
  EXPECT_LT(cloud.points.size(), points.size() / 2);
  EXPECT_GT(cloud.points.size(), 500U);
  EXPECT_LT(2.5F * meanErrorOnSphere(cloud.points), meanErrorOnSphere(points));
  EXPECT_LT(unrepresented(cloud), points.size() / 200);
  expectConsistent(cloud, points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (cloud.representatives[v] != no_index) {
      ASSERT_LT(distance(points[v], cloud.points[cloud.representatives[v]]), cloud.smoothing_radius);
    }
  }
}

TEST(ResampledNoisyCloud, OfWhatFillsSpaceHasNoSheetsThatAreMadeUp)
{
  std::mt19937 random(7);
  std::vector<Vector3> ball;
  while (ball.size() < 50000) {
    const Vector3 p{evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F)};
    if (norm(p) < 0.5F) {
      ball.push_back(p);
    }
  }
  for (const NoiseInterpretation reading : {NoiseInterpretation::Smooth, NoiseInterpretation::Close}) {
    const ResampledCloud cloud = resampleCloud(ball, nearestNeighbours(ball, 10), any_number, reading);
    EXPECT_EQ(cloud.smoothing_radius, 0.0F);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      ASSERT_EQ(cloud.points[i], ball[cloud.original[i]]);
    }
  }
}

TEST(ResampledNoisyCloud, ReadCloselyShowsMoreOfADenseCloud)
{
  // A groove that large neighbourhoods level.
  std::mt19937 random(31);
  std::vector<Vector3> points;
  while (points.size() < 60000) {
    const float x = evenly(random, -0.5F, 0.5F);
    const float depth = std::abs(x) < 0.05F ? 0.02F : 0.0F;
    points.push_back({x, evenly(random, -0.25F, 0.25F), 0.004F * bellShaped(random) - depth});
  }
  const NeighbourLists lists = nearestNeighbours(points, 10);
  const ResampledCloud smooth = resampleCloud(points, lists, any_number);
  const ResampledCloud close = resampleCloud(points, lists, any_number, NoiseInterpretation::Close);
  EXPECT_GT(close.points.size(), 2 * smooth.points.size());
  EXPECT_TRUE(close.normals.empty());
  expectConsistent(close, points.size());
}

/** Two balls pressed together: each is flat where it touches the other, and there they have one layer. */
std::vector<Vector3>
ballsInContact(float noise)
{
  constexpr float flat_at = 0.15F;
  std::vector<Vector3> points;
  for (const float side : {-1.0F, 1.0F}) {
    for (Vector3 p : sphereCloud(12000, 0.2F)) {
      p[0] = std::min(p[0], flat_at) - flat_at;
      points.push_back({side * p[0], p[1], p[2]});
    }
  }
  return noisy(points, noise, 22);
}

class SheetsInContactTest : public testing::TestWithParam<float> {};

TEST_P(SheetsInContactTest, HasTwoPointsWhereTwoSheetsTouch)
{
  const std::vector<Vector3> points = ballsInContact(GetParam());
  const NeighbourLists lists = nearestNeighbours(points, 10);
  const ResampledCloud cloud = resampleCloud(points, lists, any_number, NoiseInterpretation::Parted);
  ASSERT_EQ(cloud.normals.size(), cloud.points.size());
  ASSERT_EQ(cloud.is_oriented.size(), cloud.points.size());
  ASSERT_EQ(cloud.original.size(), cloud.points.size());
  std::size_t left = 0;
  std::size_t right = 0;
  float sum_left = 0.0F;
  float sum_right = 0.0F;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vector3& p = cloud.points[i];
    const bool is_contact = std::abs(p[0]) < 0.01F && std::hypot(p[1], p[2]) < 0.08F;
    if (!is_contact) {
      continue;
    }
    // Each sheet lies in its own body, and its normal points into the other one.
    ASSERT_NE(cloud.is_oriented[i], 0);
    ASSERT_GT(std::abs(cloud.normals[i][0]), 0.9F);
    ++(cloud.normals[i][0] > 0.0F ? left : right);
    (cloud.normals[i][0] > 0.0F ? sum_left : sum_right) += p[0];
  }
  EXPECT_GT(left, 20U);
  EXPECT_EQ(left, right);
  EXPECT_LT(sum_left, sum_right);
  std::size_t outward = 0;
  std::size_t inward = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vector3& p = cloud.points[i];
    if (cloud.is_oriented[i] != 0 && std::abs(p[0]) > 0.1F) {
      const Vector3 centre{p[0] < 0.0F ? -0.15F : 0.15F, 0.0F, 0.0F};
      ++(dot(cloud.normals[i], p - centre) > 0.0F ? outward : inward);
    }
  }
  EXPECT_GT(outward, 100U);
  EXPECT_EQ(inward, 0U);
}

INSTANTIATE_TEST_SUITE_P(PartedResampledCloud, SheetsInContactTest, testing::Values(0.0F, 0.004F));

TEST(ResampledNoisyCloud, PartedLetsBothSheetsStandForPointsOfTheCloud)
{
  const std::vector<Vector3> points = ballsInContact(0.004F);
  const ResampledCloud cloud =
      resampleCloud(points, nearestNeighbours(points, 10), any_number, NoiseInterpretation::Parted);
  std::vector<std::size_t> represented(cloud.points.size(), 0);
  for (const Index i : cloud.representatives) {
    if (i != no_index) {
      ++represented[i];
    }
  }
  EXPECT_GT(std::count_if(represented.begin(), represented.end(), [](std::size_t n) { return n > 0; }),
            static_cast<std::ptrdiff_t>(9 * cloud.points.size() / 10));
}

TEST(ResampledNoisyCloud, OfANoisyCloudLeavesOutOutliers)
{
  std::vector<Vector3> points = noisy(sphereCloud(20000, sphere_radius), 0.01F, 6);
  std::mt19937 random(7);
  const std::size_t clean = points.size();
  while (points.size() < clean + 40) {
    const Vector3 outlier{evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F)};
    if (std::abs(norm(outlier) - sphere_radius) > 0.1F) {
      points.push_back(outlier);
    }
  }
  const ResampledCloud cloud = resampledCloud(points);
  expectConsistent(cloud, points.size());
  for (std::size_t v = clean; v < points.size(); ++v) {
    EXPECT_EQ(cloud.representatives[v], no_index) << v;
  }
}

TEST(ResampledNoisyCloud, OfANoisyCloudLeavesOutLooseClusters)
{
  // Each point has most of its neighbours within the cluster, as near as these have theirs; what gives them away is
  // that there are so few.
  std::mt19937 random(11);
  std::vector<Vector3> points;
  for (int i = 0; i < 9; ++i) {
    points.push_back({evenly(random, -0.08F, 0.08F), evenly(random, -0.08F, 0.08F), evenly(random, -0.08F, 0.08F)});
  }
  const std::size_t cluster = points.size();
  const std::vector<Vector3> sphere = noisy(sphereCloud(20000, sphere_radius), 0.01F, 12);
  points.insert(points.end(), sphere.begin(), sphere.end());
  const ResampledCloud cloud = resampledCloud(points);
  ASSERT_GT(cloud.smoothing_radius, 0.0F);
  expectConsistent(cloud, points.size());
  for (std::size_t v = 0; v < cluster; ++v) {
    EXPECT_EQ(cloud.representatives[v], no_index) << v;
  }
}

TEST(ResampledNoisyCloud, OfTwoNoisySheetsStaysOnBoth)
{
  // The noise of either reaches to the middle between them, and neighbourhoods that tell the noise from the surface
  // hold points of both.
  constexpr float half_gap = 0.02F;
  std::mt19937 random(13);
  std::vector<Vector3> sheets;
  for (int i = 0; i < 30000; ++i) {
    sheets.push_back({evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F), i % 2 == 0 ? half_gap : -half_gap});
  }
  const ResampledCloud cloud = resampledCloud(noisy(sheets, 0.006F, 14));
  ASSERT_GT(cloud.smoothing_radius, 2.0F * half_gap);
  std::size_t off = 0;
  std::size_t above = 0;
  for (const Vector3& p : cloud.points) {
    off += std::abs(std::abs(p[2]) - half_gap) > 0.5F * half_gap ? 1U : 0U;
    above += p[2] > 0.0F ? 1U : 0U;
  }
  EXPECT_LT(off, cloud.points.size() / 50);
  EXPECT_GT(above, cloud.points.size() / 3);
  EXPECT_LT(above, 2 * cloud.points.size() / 3);
  expectConsistent(cloud, sheets.size());
}

TEST(ResampledNoisyCloud, IsSmoothInSparsePartsOfADenseCloud)
{
  // What is enough of the dense part for a plane is not of the sparse part.
  std::vector<Vector3> clean = sphereCloud(60000, sphere_radius);
  clean.erase(std::remove_if(clean.begin(), clean.end(), [](const Vector3& p) { return p[0] <= 0.0F; }), clean.end());
  for (const Vector3& p : sphereCloud(4000, sphere_radius)) {
    if (p[0] <= 0.0F) {
      clean.push_back(p);
    }
  }
  const std::vector<Vector3> points = noisy(clean, 0.008F, 15);
  const ResampledCloud cloud = resampledCloud(points);
  ASSERT_GT(cloud.smoothing_radius, 0.0F);
  std::vector<Vector3> before;
  std::vector<Vector3> after;
  for (std::size_t w = 0; w < cloud.points.size(); ++w) {
    if (cloud.points[w][0] < -0.1F) {
      before.push_back(points[cloud.original[w]]);
      after.push_back(cloud.points[w]);
    }
  }
  ASSERT_GT(after.size(), 200U);
  EXPECT_LT(2.0F * meanErrorOnSphere(after), meanErrorOnSphere(before));
}

TEST(ResampledNoisyCloud, OfANoisyCloudIsNoLargerThanAskedFor)
{
  const std::vector<Vector3> points = noisy(sphereCloud(20000, sphere_radius), 0.01F, 8);
  const ResampledCloud cloud = resampledCloud(points, 600);
  EXPECT_LE(cloud.points.size(), 600U);
  EXPECT_GT(cloud.points.size(), 150U);
  EXPECT_LT(2.5F * meanErrorOnSphere(cloud.points), meanErrorOnSphere(points));
  expectConsistent(cloud, points.size());
}

TEST(ResampledNoisyCloud, UnevenDensityIsNoOutlierWithNoiseEither)
{
  const std::vector<Vector3> points = noisy(unevenSphere(18000), 0.008F, 9);
  const ResampledCloud cloud = resampledCloud(points);
  ASSERT_GT(cloud.smoothing_radius, 0.0F);
  std::size_t sparse = 0;
  std::size_t dropped = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    sparse += points[v][0] < 0.0F ? 1U : 0U;
    dropped += points[v][0] < 0.0F && cloud.representatives[v] == no_index ? 1U : 0U;
  }
  EXPECT_LT(dropped, sparse / 50) << "of " << sparse;
}

TEST(ResampledNoisyCloud, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<Vector3> points = noisy(sphereCloud(12000, sphere_radius), 0.01F, 10);
  const ResampledCloud one = resampledCloud(points, 1500);
  const ResampledCloud three = withThreads(3, [&] { return resampledCloud(points, 1500); });
  ASSERT_GT(one.smoothing_radius, 0.0F);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.original, three.original);
  EXPECT_EQ(one.representatives, three.representatives);
  EXPECT_EQ(one.smoothing_radius, three.smoothing_radius);
}

} // namespace
