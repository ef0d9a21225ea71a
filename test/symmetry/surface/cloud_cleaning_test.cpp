#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "symmetry/surface/cloud_cleaning.h"
#include "symmetry/surface/scale_normalization.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A square of so many points a side at unit spacing, and one more point. */
PreparedSurface
squareAnd(const Vector3& point, int side)
{
  PreparedSurface surface;
  surface.is_cloud = true;
  for (int i = 0; i < side * side; ++i) {
    surface.points.push_back({static_cast<float>(i % side), static_cast<float>(i / side), 0.0F});
  }
  surface.points.push_back(point);
  surface.original.resize(surface.size());
  std::iota(surface.original.begin(), surface.original.end(), 0);
  surface.representatives = surface.original;
  return surface;
}

TEST(CloudCleaning, DropsWhatNoSurfaceReaches)
{
  PreparedSurface surface = squareAnd({1e7F, 0, 0}, 10);
  dropFarOutliers(surface);
  EXPECT_EQ(surface.size(), 100U);
  EXPECT_EQ(surface.summary.outliers, 1U);
  EXPECT_EQ(surface.representatives.back(), no_index);
}

TEST(CloudCleaning, KeepsWhatASurfaceMightReach)
{
  PreparedSurface surface = squareAnd({1e3F, 0, 0}, 10);
  dropFarOutliers(surface);
  EXPECT_EQ(surface.size(), 101U);
  EXPECT_EQ(surface.summary.outliers, 0U);
}

TEST(CloudCleaning, LeavesOutAFarPartAndScalesTheRestAnew)
{
  PreparedSurface surface = squareAnd({500, 0, 0}, 10);
  const std::vector<Vector3> input = surface.points;
  dropFarParts(input, SymmetryParameters{}, nearestNeighbours, surface);
  ASSERT_EQ(surface.size(), 100U);
  EXPECT_EQ(surface.summary.outliers, 1U); // too few for a part
  EXPECT_NEAR(surface.scale, 1.0F / 9.0F, 1e-6F);
  EXPECT_NEAR(distance(surface.points.front(), {-0.5F, -0.5F, 0.0F}), 0.0F, 1e-6F);
}

TEST(CloudCleaning, LeavesOutHalfOfThePointsWhereNothingShowsBesideTheWayBetween)
{
  // As far from the middle of all as the others: no median tells that they are far.
  constexpr int side = 30;
  PreparedSurface surface = squareAnd({0, 0, 0}, side);
  surface.points.pop_back();
  for (int i = 0; i < side * side; ++i) {
    surface.points.push_back(surface.points[i] + Vector3{1e5F, 0, 0});
  }
  surface.original.resize(surface.size());
  std::iota(surface.original.begin(), surface.original.end(), 0);
  surface.representatives = surface.original;
  const std::vector<Vector3> input = surface.points;
  normalizeScale(surface);
  dropFarParts(input, SymmetryParameters{}, nearestNeighbours, surface);
  EXPECT_EQ(surface.size(), 900U);
  EXPECT_EQ(surface.summary.other_components, 900U);
  EXPECT_NEAR(surface.scale, 1.0F / 29.0F, 1e-6F);
}

TEST(CloudCleaning, DropsPointsWithNeighboursUnusuallyFarAway)
{
  SymmetryParameters parameters;
  parameters.outlier_deviations = 8.0F;
  PreparedSurface surface = squareAnd({9.5F, 9.5F, 20.0F}, 20);
  dropStatisticalOutliers(surface, parameters, nearestNeighbours);
  EXPECT_EQ(surface.size(), 400U);
  EXPECT_EQ(surface.representatives.back(), no_index);
  EXPECT_EQ(surface.summary.outliers, 1U);

  PreparedSurface near = squareAnd({9.5F, 9.5F, 0.5F}, 20);
  dropStatisticalOutliers(near, parameters, nearestNeighbours);
  EXPECT_EQ(near.size(), 401U);
}

TEST(CloudCleaning, CompletesNormalsByThePlaneOfTheNeighbours)
{
  UsablePoints usable;
  usable.surface = squareAnd({4.5F, 4.5F, 0.0F}, 10);
  usable.surface.normals.assign(usable.surface.size(), Vector3{0, 0, -1});
  usable.surface.normals[55] = {0, 0, 0};
  usable.neighbours = nearestNeighbours(usable.surface.points, 8);
  completeNormals(usable);
  EXPECT_NEAR(std::abs(usable.surface.normals[55][2]), 1.0F, 1e-5F);
  EXPECT_EQ(usable.is_oriented[55], 0);
  EXPECT_EQ(usable.is_oriented[54], 1);
  EXPECT_EQ(usable.surface.normals[54], (Vector3{0, 0, -1}));
}

} // namespace
