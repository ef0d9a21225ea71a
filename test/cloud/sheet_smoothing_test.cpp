#include "cloud/clouds.h"
#include "cloud/sheet_smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Points spread evenly over a square, with noise across it. \param[in] dense share of them in the right half */
std::vector<Vector3>
noisySquare(std::size_t n, float height, float noise, float dense, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const bool right = evenly(random, 0.0F, 1.0F) < dense;
    points.push_back({right ? evenly(random, 0.0F, 0.5F) : evenly(random, -0.5F, 0.0F), evenly(random, -0.5F, 0.5F),
                      height + noise * bellShaped(random)});
  }
  return points;
}

TEST(Smoothing, OfACloudWithoutNoiseStaysNone)
{
  const Smoothing none = findSmoothing(sphereCloud(5000, 0.4F), 0.02F);
  EXPECT_EQ(none.radius, 0.0F);
  EXPECT_EQ(withLeastRadius(none, 0.02F).least_radius, 0.0F);
}

/** Two thirds of the points lie in two sheets less than a spacing apart, as of a curled body: noise would be everywhere.
 */
TEST(Smoothing, OfSheetsInContactStaysNone)
{
  constexpr float spacing = 0.02F;
  std::vector<Vector3> points = noisySquare(3000, 0.0F, 0.0F, 0.5F, 5);
  std::vector<Vector3> above = noisySquare(1500, 0.6F * spacing, 0.0F, 0.0F, 6); // over the left half
  points.insert(points.end(), above.begin(), above.end());
  EXPECT_EQ(findSmoothing(points, spacing).radius, 0.0F);
  std::vector<Vector3> noisy = noisySquare(4500, 0.0F, 0.3F * spacing, 0.5F, 7);
  EXPECT_GT(findSmoothing(noisy, spacing).radius, 0.0F);
}

/** A tube of unit length, less than four spacings thick; noise in spacings. */
std::vector<Vector3>
thinTube(float spacing, float noise, std::uint32_t seed)
{
  constexpr int around = 11;
  const float radius = 1.8F * spacing;
  std::mt19937 random(seed);
  std::vector<Vector3> points;
  for (int row = 0; static_cast<float>(row) * spacing < 1.0F; ++row) {
    for (int k = 0; k < around; ++k) {
      const float angle = 6.2831853F * (static_cast<float>(k) + 0.5F * static_cast<float>(row % 2)) / around;
      const float r = radius + noise * spacing * bellShaped(random);
      points.push_back({static_cast<float>(row) * spacing, r * std::cos(angle), r * std::sin(angle)});
    }
  }
  return points;
}

TEST(Smoothing, TakesNoCurvatureForNoise)
{
  constexpr float spacing = 0.01F;
  EXPECT_EQ(findSmoothing(thinTube(spacing, 0.0F, 1), spacing).radius, 0.0F);
  EXPECT_GT(findSmoothing(thinTube(spacing, 0.4F, 2), spacing).radius, 0.0F);
}

TEST(Smoothing, DoesNotHangOnTheOrderOfThePoints)
{
  constexpr float spacing = 0.02F;
  std::size_t noisy = 0;
  for (int percent = 10; percent <= 40; percent += 3) { // among these is the limit
    std::vector<Vector3> points = noisySquare(4500, 0.0F, 0.01F * static_cast<float>(percent) * spacing, 0.5F, 8);
    const bool is_noisy = findSmoothing(points, spacing).radius > 0.0F;
    noisy += is_noisy ? 1U : 0U;
    std::mt19937 random(9);
    for (int times = 0; times < 4; ++times) {
      std::shuffle(points.begin(), points.end(), random);
      EXPECT_EQ(findSmoothing(points, spacing).radius > 0.0F, is_noisy) << percent;
    }
  }
  EXPECT_GT(noisy, 0U);
  EXPECT_LT(noisy, 11U);
}

TEST(Smoothing, WithLeastRadiusFollowsTheDensity)
{
  const Smoothing even{0.06F, 0.06F, 0.02F, 0.01F};
  const Smoothing dense = withLeastRadius(even, 0.003F);
  const Smoothing sparse = withLeastRadius(even, 0.02F);
  EXPECT_LT(dense.least_radius, 0.5F * even.radius);
  EXPECT_GE(dense.least_radius, 6.0F * 0.003F);
  EXPECT_LT(dense.spacing, even.spacing);
  EXPECT_EQ(dense.radius, even.radius);
  EXPECT_EQ(dense.width, even.width);
  EXPECT_EQ(sparse.least_radius, even.radius); // there are too few points for smaller neighbourhoods
  EXPECT_EQ(sparse.spacing, even.spacing);
}

TEST(MoveToSheets, WidensNeighbourhoodsWherePointsAreSparse)
{
  constexpr float noise = 0.01F;
  const std::vector<Vector3> points = noisySquare(30000, 0.0F, noise, 0.95F, 3);
  const Smoothing smoothing{0.1F, 0.03F, 0.04F, 0.005F};
  const SheetPlaces sheets = moveToSheets(points, points, smoothing);
  ASSERT_EQ(sheets.places.size(), points.size());
  double error[2] = {0.0, 0.0};
  double gap[2] = {0.0, 0.0};
  std::size_t number[2] = {0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i][0]) < 0.1F || std::abs(points[i][0]) > 0.4F || std::abs(points[i][1]) > 0.4F) {
      continue;
    }
    const std::size_t half = points[i][0] < 0.0F ? 0 : 1;
    error[half] += std::abs(double{sheets.places[i][2]});
    gap[half] += double{sheets.gaps[i]};
    ++number[half];
  }
  for (std::size_t half = 0; half < 2; ++half) {
    EXPECT_LT(error[half] / static_cast<double>(number[half]), 0.25 * double{noise}) << half;
  }
  // The gap of n points on an area is sqrt (area / n): 0.5 / 28500 and 0.5 / 1500.
  EXPECT_NEAR(gap[1] / static_cast<double>(number[1]), 0.0042, 0.0006);
  EXPECT_NEAR(gap[0] / static_cast<double>(number[0]), 0.0183, 0.0025);
}

TEST(MoveToSheets, SmallNeighbourhoodsKeepABumpThatLargeOnesLevel)
{
  constexpr float height = 0.05F;
  constexpr float width = 0.05F;
  std::vector<Vector3> points = noisySquare(60000, 0.0F, 0.004F, 0.5F, 4);
  for (Vector3& p : points) {
    const float r = std::hypot(p[0], p[1]);
    p[2] += height * std::exp(-(r * r) / (width * width));
  }
  const auto top = [&](float least_radius) {
    const SheetPlaces sheets =
        moveToSheets({{0.0F, 0.0F, height}}, points, Smoothing{0.12F, least_radius, 0.1F, 0.005F});
    return sheets.places[0][2];
  };
  EXPECT_GT(top(0.03F), 0.85F * height);
  EXPECT_LT(top(0.12F), 0.7F * height);
}

} // namespace
