#include "support/with_threads.h"
#include "cloud/clouds.h"
#include "cloud/resampled_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float sphere_radius = 0.4F;
constexpr std::size_t any_number = 1000000;

ResampledCloud
resampledCloud(const std::vector<Vector3>& points, std::size_t most = any_number)
{
  return resampleCloud(points, nearestNeighbours(points, 10), most);
}

float
meanErrorOnSphere(const std::vector<Vector3>& points)
{
  double sum = 0.0;
  for (const Vector3& p : points) {
    sum += std::abs(double{norm(p)} - double{sphere_radius});
  }
  return static_cast<float>(sum / static_cast<double>(points.size()));
}

std::size_t
unrepresented(const ResampledCloud& cloud)
{
  return static_cast<std::size_t>(std::count(cloud.representatives.begin(), cloud.representatives.end(), no_index));
}

/** One half of a sphere sampled ten times as densely as the other. */
std::vector<Vector3>
unevenSphere(std::size_t n)
{
  std::vector<Vector3> points;
  for (const Vector3& p : sphereCloud(2 * n, sphere_radius)) {
    if (p[0] > 0.0F) {
      points.push_back(p);
    }
  }
  for (const Vector3& p : sphereCloud(n / 5, sphere_radius)) {
    if (p[0] <= 0.0F) {
      points.push_back(p);
    }
  }
  return points;
}

/** What holds for any resampled cloud. */
void
expectConsistent(const ResampledCloud& cloud, std::size_t points)
{
  ASSERT_EQ(cloud.representatives.size(), points);
  ASSERT_EQ(cloud.original.size(), cloud.points.size());
  for (const Index representative : cloud.representatives) {
    ASSERT_GE(representative, no_index);
    ASSERT_LT(representative, static_cast<Index>(cloud.points.size()));
  }
  for (std::size_t w = 0; w < cloud.points.size(); ++w) {
    ASSERT_EQ(cloud.representatives[cloud.original[w]], static_cast<Index>(w)); // each stands for itself
  }
}

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

TEST(ResampledCloud, LiesOnTheSurfaceThatNoiseHides)
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

TEST(ResampledCloud, ReadCloselyShowsMoreOfADenseCloud)
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

TEST(ResampledCloud, PartedLetsBothSheetsStandForPointsOfTheCloud)
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

TEST(ResampledCloud, OfANoisyCloudLeavesOutOutliers)
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

TEST(ResampledCloud, OfANoisyCloudLeavesOutLooseClusters)
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

TEST(ResampledCloud, OfTwoNoisySheetsStaysOnBoth)
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

TEST(ResampledCloud, IsSmoothInSparsePartsOfADenseCloud)
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

TEST(ResampledCloud, OfANoisyCloudIsNoLargerThanAskedFor)
{
  const std::vector<Vector3> points = noisy(sphereCloud(20000, sphere_radius), 0.01F, 8);
  const ResampledCloud cloud = resampledCloud(points, 600);
  EXPECT_LE(cloud.points.size(), 600U);
  EXPECT_GT(cloud.points.size(), 150U);
  EXPECT_LT(2.5F * meanErrorOnSphere(cloud.points), meanErrorOnSphere(points));
  expectConsistent(cloud, points.size());
}

TEST(ResampledCloud, UnevenDensityIsNoOutlier)
{
  const std::vector<Vector3> clean = unevenSphere(5000);
  const ResampledCloud cloud = resampledCloud(clean);
  EXPECT_EQ(cloud.smoothing_radius, 0.0F);
  EXPECT_LE(unrepresented(cloud), 3U);
  EXPECT_EQ(cloud.points.size(), clean.size() - unrepresented(cloud));
}

TEST(ResampledCloud, UnevenDensityIsNoOutlierWithNoiseEither)
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

TEST(ResampledCloud, IsTheSameForAnyNumberOfThreads)
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
