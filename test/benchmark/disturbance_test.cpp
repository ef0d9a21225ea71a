#include "benchmark/disturbance.h"
#include "support/messages.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

TEST(DisturbanceTest, NothingAskedNothingChanged)
{
  const Surface grid = test::gridMesh(5, 4);
  const DisturbedSurface same = disturb(grid, {});
  EXPECT_EQ(same.surface.points, grid.points);
  EXPECT_EQ(same.surface.triangles, grid.triangles);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_EQ(same.origins[i], static_cast<Index>(i));
}

TEST(DisturbanceTest, RemembersWhichPointIsWhich)
{
  const Surface grid = test::gridMesh(20, 10);
  const DisturbedSurface disturbed = disturb(grid, {0.0, 0.1, 0.05, 3});
  ASSERT_EQ(disturbed.origins.size(), 189U) << "200 - 20 + 9";
  ASSERT_EQ(disturbed.surface.size(), 189U);
  std::vector<int> met(grid.size(), 0);
  for (std::size_t i = 0; i < 180; ++i) {
    const auto origin = static_cast<std::size_t>(disturbed.origins[i]);
    EXPECT_EQ(disturbed.surface.points[i], grid.points[origin]);
    EXPECT_EQ(++met[origin], 1);
  }
  for (std::size_t i = 180; i < 189; ++i)
    EXPECT_EQ(disturbed.origins[i], no_index) << "outliers come last";
  for (const Triangle& t : disturbed.surface.triangles)
    for (const Index i : t)
      EXPECT_LT(i, 180);
}

TEST(DisturbanceTest, HolesAndThinningTakePointsAway)
{
  const Surface grid = test::gridMesh(60, 60);
  Disturbance disturbance;
  disturbance.holes = 1;
  disturbance.hole_share = 0.2;
  const DisturbedSurface with_hole = disturb(grid, disturbance);
  EXPECT_NEAR(static_cast<double>(with_hole.origins.size()), 0.8 * 3600.0, 20.0);
  EXPECT_TRUE(with_hole.surface.hasFaces());

  disturbance.thin = 10.0;
  const DisturbedSurface both = disturb(grid, disturbance);
  EXPECT_LT(both.origins.size(), with_hole.origins.size());
  EXPECT_TRUE(
      std::includes(with_hole.origins.begin(), with_hole.origins.end(), both.origins.begin(), both.origins.end()));
  for (std::size_t i = 0; i < both.origins.size(); ++i)
    EXPECT_EQ(both.surface.points[i], grid.points[static_cast<std::size_t>(both.origins[i])]);
}

TEST(DisturbanceTest, RepeatedPointsKnowTheirOrigin)
{
  const Surface grid = test::gridMesh(20, 10);
  Disturbance disturbance;
  disturbance.drop = 0.5;
  disturbance.repeat = 0.3;
  disturbance.outliers = 0.1;
  const DisturbedSurface repeated = disturb(grid, disturbance);
  ASSERT_EQ(repeated.origins.size(), 100U + 30U + 13U);
  for (std::size_t i = 0; i < 130; ++i)
    EXPECT_EQ(repeated.surface.points[i], grid.points[static_cast<std::size_t>(repeated.origins[i])]);
  EXPECT_EQ(repeated.origins.back(), no_index);
}

TEST(DisturbanceTest, RoundingGoesToMultiplesOfTheStep)
{
  const Surface grid = test::gridMesh(30, 40);
  Disturbance disturbance;
  disturbance.quantise = 0.1;
  const double step = 0.1 * std::hypot(29.0, 39.0);
  const DisturbedSurface rounded = disturb(grid, disturbance);
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(rounded.surface.points[i][k], step * std::round(double(grid.points[i][k]) / step), 1e-4);
}

TEST(DisturbanceTest, BendingMovesPointsAndKeepsThemAll)
{
  const Surface grid = test::gridMesh(30, 40);
  Disturbance disturbance;
  disturbance.bend = 0.5;
  EXPECT_FALSE(disturbance.changesNothing());
  const DisturbedSurface bent = disturb(grid, disturbance);
  ASSERT_EQ(bent.surface.size(), grid.size());
  EXPECT_NE(bent.surface.points, grid.points);
  EXPECT_EQ(bent.surface.triangles, grid.triangles);
}

TEST(DisturbanceTest, NoiseHasTheDeviationAskedFor)
{
  const Surface grid = test::gridMesh(100, 100);
  const DisturbedSurface noisy = disturb(grid, {0.01, 0.0, 0.0, 1});
  double squared = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      squared += std::pow(double(noisy.surface.points[i][k]) - double(grid.points[i][k]), 2);
  const double expected = 0.01 * 99.0 * std::sqrt(2.0);
  EXPECT_NEAR(std::sqrt(squared / static_cast<double>(grid.size())), expected, 0.05 * expected);
}

TEST(DisturbanceTest, TheSeedDecides)
{
  const Surface grid = test::gridMesh(20, 10);
  const Disturbance first{0.01, 0.1, 0.1, 5};
  Disturbance second = first;
  second.seed = 6;
  EXPECT_EQ(disturb(grid, first).surface.points, disturb(grid, first).surface.points);
  EXPECT_NE(disturb(grid, first).surface.points, disturb(grid, second).surface.points);
}

TEST(DisturbanceTest, MapsGoBackToTheNumbersBefore)
{
  // Points 4, 1 and 0 of five are left, then comes an outlier.
  const std::vector<Index> origins{4, 1, 0, no_index};
  EXPECT_EQ(undisturbMap({2, no_index, 3, 0}, origins, 5),
            (std::vector<Index>{no_index, no_index, no_index, no_index, 0}));
  EXPECT_EQ(undisturbMap({1, 0, 2, 3}, origins, 5), (std::vector<Index>{0, 4, no_index, no_index, 1}));
}

TEST(DisturbanceTest, RejectsSharesOutOfRange)
{
  const auto error = [](const Disturbance& disturbance) {
    return test::messageOf<pcl::BadArgumentException>([&] { disturb(test::gridMesh(3, 3), disturbance); });
  };
  EXPECT_NE(error({-0.1, 0.0, 0.0, 1}).find("noise -0.1 is not in [0, 1]"), std::string::npos);
  EXPECT_NE(error({0.0, 1.0, 0.0, 1}).find("drop 1 is not in [0, 0.99]"), std::string::npos);
  EXPECT_NE(error({0.0, 0.0, 1.5, 1}).find("outliers 1.5 is not in [0, 1]"), std::string::npos);
  Disturbance thinner;
  thinner.thin = 0.5;
  EXPECT_NE(error(thinner).find("thin 0.5 is not in [1, 1000]"), std::string::npos);
  EXPECT_NE(error({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 1}), "");
}

} // namespace
} // namespace symmetry
} // namespace pcl
