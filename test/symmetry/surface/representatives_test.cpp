// Which points of a prepared_surface.h stand for those of the input.
#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "support/graphs.h"
#include "support/prepared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

PreparedSurface
preparedCloud(const std::vector<Vector3>& points)
{
  Surface cloud;
  cloud.points = points;
  return prepareSurface(cloud, SymmetryParameters{}, nearestNeighbours);
}

std::size_t
represented(const PreparedSurface& prepared)
{
  return prepared.representatives.size() -
         static_cast<std::size_t>(
             std::count(prepared.representatives.begin(), prepared.representatives.end(), no_index));
}

// In the unit of the input.
constexpr float cloud_radius = 40.0F;
constexpr float noise = 1.0F;

TEST(Representatives, AreTheVerticesThemselvesOnAMesh)
{
  const Surface mesh = sphereMesh(3);
  const PreparedSurface prepared = preparedMesh(mesh);
  ASSERT_EQ(prepared.representatives.size(), mesh.size());
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    EXPECT_EQ(prepared.representatives[v], static_cast<Index>(v));
  }
  EXPECT_EQ(prepared.summary.used, mesh.size());
  EXPECT_EQ(prepared.summary.working_points, mesh.size());
}

TEST(Representatives, AreMissingForWhatIsLeftOutOfAMesh)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Surface grid = gridMesh(7, 5);
  Surface mesh = grid;
  // A triangle apart and a point of no triangle in front, a point that is none in the middle.
  mesh.points.insert(mesh.points.begin() + 10, {nan, 0, 0});
  mesh.points.insert(mesh.points.begin(), {{20, 0, 0}, {21, 0, 0}, {20, 1, 0}, {9, 9, 9}});
  const auto moved = [](Index v) {
    return v < 10 ? v + 4 : v + 5;
  };
  for (Triangle& t : mesh.triangles) {
    t = {moved(t[0]), moved(t[1]), moved(t[2])};
  }
  mesh.triangles.push_back({0, 1, 2});
  const PreparedSurface prepared = preparedMesh(mesh);
  ASSERT_EQ(prepared.representatives.size(), mesh.size());
  for (const Index left_out : {0, 1, 2, 3, 14}) {
    EXPECT_EQ(prepared.representatives[left_out], no_index);
  }
  for (std::size_t v = 0; v < grid.size(); ++v) {
    EXPECT_EQ(prepared.representatives[moved(static_cast<Index>(v))], static_cast<Index>(v));
  }
  EXPECT_EQ(prepared.summary.used, grid.size());
  EXPECT_EQ(prepared.summary.other_components, 3U);
  EXPECT_EQ(prepared.summary.unused, 1U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
}

TEST(Representatives, OfACleanCloudAreItsPoints)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Vector3> points = sphereCloud(1500, cloud_radius);
  points.insert(points.begin() + 700, {nan, nan, nan});
  points.insert(points.begin() + 300, {0.0F, 0.0F, 0.0F}); // far from all others
  const std::vector<Vector3> apart = sphereCloud(200, 5.0F, {100.0F, 0.0F, 0.0F});
  points.insert(points.begin(), apart.begin(), apart.end());
  const PreparedSurface prepared = preparedCloud(points);
  ASSERT_EQ(prepared.size(), 1500U);
  EXPECT_EQ(prepared.summary.used, 1500U);
  EXPECT_EQ(prepared.summary.working_points, 1500U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
  EXPECT_EQ(prepared.summary.outliers, 1U);
  EXPECT_EQ(prepared.summary.other_components, apart.size());
  EXPECT_EQ(prepared.summary.smoothing_radius, 0.0F);
  ASSERT_EQ(prepared.representatives.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool left_out = v < 200 || v == 500 || v == 901;
    ASSERT_EQ(prepared.representatives[v] == no_index, left_out) << v;
    if (!left_out) {
      ASSERT_EQ(prepared.original[prepared.representatives[v]], static_cast<Index>(v));
    }
  }
}

TEST(Representatives, OfRepeatedPointsAreTheFirstOnes)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = preparedCloud(sphere);
  std::vector<Vector3> points = sphere;
  for (std::size_t v = 0; v < 1500; v += 2) {
    for (int time = 0; time < 12; ++time) { // more copies than a point has neighbours
      points.push_back(Vector3(sphere[v]));
    }
  }
  const PreparedSurface prepared = preparedCloud(points);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.graph.lengths, expected.graph.lengths);
  EXPECT_EQ(prepared.summary.used, points.size());
  EXPECT_EQ(prepared.summary.outliers, 0U);
  for (std::size_t i = 1500; i < points.size(); ++i) {
    ASSERT_EQ(prepared.representatives[i], static_cast<Index>((i - 1500) / 12 * 2));
  }
}

TEST(Representatives, AreMissingForOutliersHoweverFarAway)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = preparedCloud(sphere);
  for (const float far : {1e6F, 1e12F, 1e30F}) {
    std::vector<Vector3> points = sphere;
    points.push_back({far, -far, 0.0F});
    const PreparedSurface prepared = preparedCloud(points);
    EXPECT_EQ(prepared.points, expected.points) << far;
    EXPECT_EQ(prepared.summary.outliers, 1U) << far;
    EXPECT_EQ(prepared.representatives.back(), no_index) << far;
  }
}

TEST(Representatives, AnOutlierFarAwayCostsNoPrecision)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = preparedCloud(sphere);
  std::vector<Vector3> points = sphere;
  points.push_back({5000.0F * cloud_radius, 0.0F, 0.0F});
  const PreparedSurface prepared = preparedCloud(points);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.summary.outliers, 1U);
}

TEST(Representatives, WhatIsFarFromANoisyCloudDoesNotWidenItsSmoothing)
{
  const std::vector<Vector3> sphere = noisy(sphereCloud(15000, cloud_radius), noise, 1);
  const PreparedSurface expected = preparedCloud(sphere);
  ASSERT_GT(expected.summary.smoothing_radius, 0.0F);
  std::vector<Vector3> points = sphere;
  points.push_back({25.0F * cloud_radius, 0.0F, 0.0F});
  const std::vector<Vector3> other =
      noisy(sphereCloud(2000, cloud_radius, {0.0F, 30.0F * cloud_radius, 0.0F}), noise, 2);
  points.insert(points.end(), other.begin(), other.end());
  const PreparedSurface prepared = preparedCloud(points);
  EXPECT_NEAR(prepared.summary.smoothing_radius, expected.summary.smoothing_radius, 1e-3F * cloud_radius);
  EXPECT_EQ(prepared.size(), expected.size());
  EXPECT_EQ(prepared.summary.outliers, expected.summary.outliers + 1);
  EXPECT_EQ(prepared.summary.other_components, expected.summary.other_components + other.size());
  EXPECT_EQ(prepared.summary.components, expected.summary.components + 1);
}

TEST(Representatives, OfANoisyCloudAreShared)
{
  std::vector<Vector3> points = noisy(sphereCloud(15000, cloud_radius), noise, 1);
  const std::vector<Vector3> apart = noisy(sphereCloud(600, 8.0F, {80.0F, 0.0F, 0.0F}), noise, 2);
  points.insert(points.begin() + 5000, apart.begin(), apart.end());
  points[0] = {std::numeric_limits<float>::infinity(), 0.0F, 0.0F};
  const PreparedSurface prepared = preparedCloud(points);
  const InputSummary& summary = prepared.summary;
  EXPECT_GT(summary.smoothing_radius, 2.0F * noise); // in the unit of the input
  EXPECT_LT(summary.smoothing_radius, 0.5F * cloud_radius);
  EXPECT_EQ(summary.working_points, prepared.size());
  EXPECT_LT(prepared.size(), points.size() / 2);
  EXPECT_EQ(summary.used, represented(prepared));
  EXPECT_GT(summary.used, 14000U);
  EXPECT_EQ(summary.used + summary.non_finite + summary.outliers + summary.other_components, points.size());

  ASSERT_EQ(prepared.representatives.size(), points.size());
  EXPECT_EQ(prepared.representatives[0], no_index);
  for (std::size_t v = 5000; v < 5600; ++v) {
    ASSERT_EQ(prepared.representatives[v], no_index); // of the smaller sphere
  }
  for (std::size_t w = 0; w < prepared.size(); ++w) {
    ASSERT_EQ(prepared.representatives[prepared.original[w]], static_cast<Index>(w));
  }
  // Near what they stand for, but for the shift of the box: differences between two of them are those of their points.
  const Index first = prepared.representatives[100];
  ASSERT_NE(first, no_index);
  for (std::size_t v = 101; v < 5000; v += 7) {
    const Index other = prepared.representatives[v];
    if (other != no_index) {
      const Vector3 here = (1.0F / prepared.scale) * (prepared.points[other] - prepared.points[first]);
      ASSERT_LT(distance(here, points[v] - points[100]), 2.0F * summary.smoothing_radius);
    }
  }
}

} // namespace
