#include "base/vector_math.h"
#include "support/prepared.h"
#include "symmetry/sides/axis_smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Root mean square of a function less what it should be, at the vertices of a sphere near the plane x = 0. */
float
deviation(const Surface& sphere, const std::vector<float>& values)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    if (std::abs(sphere.points[v][0]) < 0.05F) {
      const double off = values[v] - sphere.points[v][0];
      sum += off * off;
      ++count;
    }
  }
  return static_cast<float>(std::sqrt(sum / static_cast<double>(count)));
}

TEST(SmoothedNearAxis, TakesNoiseAway)
{
  const Surface sphere = sphereMesh(5);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-0.03F, 0.03F); // an edge is as long
  std::vector<float> values;
  for (const Vector3& p : sphere.points) {
    values.push_back(p[0] + noise(random));
  }
  const std::vector<float> smooth = smoothedNearAxis(prepared(sphere), values);
  EXPECT_LT(deviation(sphere, smooth), 0.4F * deviation(sphere, values));
}

TEST(SmoothedNearAxis, EndsWhereFacesJoinWhatIsFarApart)
{
  // No order of the points keeps the factor of their matrix sparse: to make it would take a minute.
  Surface sphere = sphereMesh(6);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> noise(-0.015F, 0.015F);
  std::vector<Index> near;
  std::vector<float> values;
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    values.push_back(sphere.points[v][0] + noise(random));
    if (std::abs(sphere.points[v][0]) < 0.2F) {
      near.push_back(static_cast<Index>(v));
    }
  }
  std::uniform_int_distribution<std::size_t> any(0, near.size() - 1);
  for (std::size_t i = 0; i < near.size(); ++i) {
    sphere.triangles.push_back({near[i], near[any(random)], near[any(random)]});
  }
  const std::vector<float> smooth = smoothedNearAxis(prepared(sphere), values);
  EXPECT_NE(smooth, values);
  EXPECT_TRUE(std::all_of(smooth.begin(), smooth.end(), [](float x) { return std::abs(x) <= 1.02F; }));
}

TEST(SmoothedNearAxis, LeavesTheZeroOfAnAntisymmetricFunctionWhereItIs)
{
  // Not a mirror image in its triangles: the vertices are moved to and fro on one side.
  Surface sphere = sphereMesh(5);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> step(-0.01F, 0.01F);
  for (Vector3& p : sphere.points) {
    if (p[0] > 0.0F) {
      p = normalized(p + Vector3{0.0F, step(random), step(random)});
    }
  }
  std::vector<float> values;
  for (const Vector3& p : sphere.points) {
    values.push_back(2.0F * p[0]);
  }
  const std::vector<float> smooth = smoothedNearAxis(prepared(sphere), values);
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    if (std::abs(sphere.points[v][0]) < 0.05F) {
      EXPECT_NEAR(smooth[v], values[v], 0.006F); // a tenth of an edge
    }
    if (std::abs(sphere.points[v][0]) > 0.4F) {
      EXPECT_EQ(smooth[v], values[v]) << "far from the axis";
    }
  }
}

TEST(SmoothedNearAxis, LeavesOneSideAsItIs)
{
  const Surface grid = gridMesh(5, 5);
  const std::vector<float> values(25, 1.0F);
  EXPECT_EQ(smoothedNearAxis(prepared(grid), values), values);
}

TEST(SmoothedNearAxis, LeavesWhatHasNoTriangles)
{
  Surface grid = gridMesh(6, 6);
  PreparedSurface surface = prepared(grid);
  surface.triangles.clear();
  std::vector<float> values;
  for (const Vector3& p : grid.points) {
    values.push_back(p[0] - 2.6F);
  }
  const std::vector<float> smooth = smoothedNearAxis(surface, values);
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_FLOAT_EQ(smooth[v], values[v]);
  }
}

} // namespace
