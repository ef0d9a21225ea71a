#include "base/vector_math.h"
#include "geodesic/neighbour_graph.h"
#include "support/shapes.h"
#include "symmetry/sides/axis_curve.h"
#include "symmetry/sides/sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** x, with a little wave: the axis curve is near the plane x = offset but not along mesh edges. */
std::vector<float>
waveFunction(const Surface& surface, float offset)
{
  std::vector<float> values;
  for (const Vector3& p : surface.points) {
    values.push_back(p[0] - offset + 0.03F * std::sin(9.0F * p[1] + 4.0F * p[2]));
  }
  return values;
}

/** k-nearest-neighbour graph by brute force. */
SurfaceGraph
cloudGraph(const std::vector<Vector3>& points, std::size_t k)
{
  NeighbourLists lists;
  lists.k = k;
  std::vector<Index> order(points.size());
  for (const Vector3& p : points) {
    std::iota(order.begin(), order.end(), 0);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                      [&](Index a, Index b) { return distance(points[a], p) < distance(points[b], p); });
    lists.neighbours.insert(lists.neighbours.end(), order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return buildNeighbourGraph(points, lists, 0.0F);
}

float
length(const SurfaceGraph& graph, const Polyline& line)
{
  float sum = line.closed ? edgeLength(graph, line.points.back(), line.points.front()) : 0.0F;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    sum += edgeLength(graph, line.points[i - 1], line.points[i]);
  }
  return sum;
}

/** What holds for every axis: neighbours follow each other, labels agree, longest first, no vertex twice. */
void
expectWellFormed(const SurfaceGraph& graph, const std::vector<Side>& sides, const std::vector<Polyline>& axis)
{
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const std::vector<Index>& points = axis[i].points;
    EXPECT_TRUE(std::isfinite(length(graph, axis[i]))) << "a step that is no edge";
    EXPECT_EQ(std::set<Index>(points.begin(), points.end()).size(), points.size()) << "a vertex twice";
    for (const Index v : points) {
      EXPECT_EQ(sides[v], Side::Axis);
    }
    if (i > 0) {
      EXPECT_LE(length(graph, axis[i]), length(graph, axis[i - 1]));
    }
  }
}

struct Traced {
  SurfaceGraph graph;
  std::vector<Side> sides;
  std::vector<Polyline> axis;
};

Traced
trace(SurfaceGraph graph, const std::vector<Triangle>& triangles, const std::vector<float>& values)
{
  Traced traced;
  const std::vector<float> side_function = absorbSpecks(graph, values);
  traced.sides = labelSides(graph, side_function);
  traced.axis = traceAxis(graph, triangles, side_function, traced.sides);
  traced.graph = std::move(graph);
  expectWellFormed(traced.graph, traced.sides, traced.axis);
  return traced;
}

Traced
traceMesh(const Surface& mesh, float offset)
{
  return trace(buildMeshGraph(mesh.points, mesh.triangles), mesh.triangles, waveFunction(mesh, offset));
}

Traced
traceCloud(const Surface& surface, float offset)
{
  return trace(cloudGraph(surface.points, 10), {}, waveFunction(surface, offset));
}

/** Points spread evenly but not on a lattice. */
Surface
sphereCloud(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Surface cloud;
  while (cloud.points.size() < count) {
    const Vector3 p = normalized({normal(random), normal(random), normal(random)});
    const bool crowded = std::any_of(cloud.points.begin(), cloud.points.end(),
                                     [&p](const Vector3& other) { return distance(p, other) < 0.03F; });
    if (!crowded) {
      cloud.points.push_back(p);
    }
  }
  return cloud;
}

} // namespace

TEST(AxisOfMesh, IsOneClosedCurveOnASphere)
{
  const Surface sphere = sphereMesh(5);
  const Traced traced = traceMesh(sphere, 0.1F);
  ASSERT_EQ(traced.axis.size(), 1U);
  EXPECT_TRUE(traced.axis[0].closed);
  // At most 4 % more than the circle, but for the zigzag of edges (up to 2 / sqrt (3) on equilateral triangles).
  EXPECT_GT(length(traced.graph, traced.axis[0]), 2.0F * 3.14159F * 0.99F);
  EXPECT_LT(length(traced.graph, traced.axis[0]), 2.0F * 3.14159F * 1.2F);
  for (const Index v : traced.axis[0].points) {
    EXPECT_NEAR(sphere.points[v][0], 0.1F, 0.06F);
  }
}

TEST(AxisOfMesh, HasTwoPartsOnATorusTheLongerFirst)
{
  Surface torus = torusMesh(120, 40, 2.0F, 0.7F);
  for (Vector3& p : torus.points) {
    p[2] *= p[1] > 0.0F ? 1.5F : 1.0F; // the part at y > 0 has the longer section
  }
  const Traced traced = traceMesh(torus, 0.0F);
  ASSERT_EQ(traced.axis.size(), 2U);
  EXPECT_TRUE(traced.axis[0].closed);
  EXPECT_TRUE(traced.axis[1].closed);
  EXPECT_GT(torus.points[traced.axis[0].points[0]][1], 0.0F);
  EXPECT_LT(torus.points[traced.axis[1].points[0]][1], 0.0F);
}

TEST(AxisOfMesh, EndsAtTheBoundary)
{
  const Surface grid = gridMesh(30, 20);
  const Traced traced = traceMesh(grid, 14.5F);
  ASSERT_EQ(traced.axis.size(), 1U);
  EXPECT_FALSE(traced.axis[0].closed);
  const float first = grid.points[traced.axis[0].points.front()][1];
  const float last = grid.points[traced.axis[0].points.back()][1];
  EXPECT_EQ(std::min(first, last), 0.0F);
  EXPECT_EQ(std::max(first, last), 19.0F);
}

TEST(AxisOfMesh, StopsAtAnEdgeOfThreeTriangles)
{
  // Three sheets that meet along the line x = 0, z = 0; the function changes its sign across them all, at y = 4.5.
  Surface sheets = gridMesh(6, 10);
  const std::vector<Triangle> sheet = sheets.triangles;
  for (const Vector3& up : {Vector3{-0.5F, 0.0F, 0.8F}, Vector3{-0.5F, 0.0F, -0.8F}}) {
    std::vector<Index> number;
    for (int v = 0; v < 60; ++v) {
      number.push_back(v % 6 == 0 ? v : static_cast<Index>(sheets.points.size()));
      if (v % 6 != 0) {
        const auto x = static_cast<float>(v % 6);
        sheets.points.push_back({x * up[0], static_cast<float>(v / 6), x * up[2]});
      }
    }
    for (const Triangle& t : sheet) {
      sheets.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    }
  }
  std::vector<float> values;
  for (const Vector3& p : sheets.points) {
    values.push_back(p[1] - 4.4F);
  }
  const Traced traced = trace(buildMeshGraph(sheets.points, sheets.triangles), sheets.triangles, values);
  ASSERT_EQ(traced.axis.size(), 3U);
  for (const Polyline& line : traced.axis) {
    EXPECT_FALSE(line.closed);
    EXPECT_GE(line.points.size(), 5U);
  }
}

TEST(AxisOfMesh, IsEmptyWhereThereIsOneSideOnly)
{
  const Surface sphere = sphereMesh(3);
  EXPECT_TRUE(traceMesh(sphere, 5.0F).axis.empty());
  EXPECT_TRUE(
      trace(buildMeshGraph(sphere.points, sphere.triangles), {}, std::vector<float>(sphere.size(), 1.0F)).axis.empty());
}

TEST(AxisOfMesh, DoesNotGoAroundSpecks)
{
  const Surface sphere = sphereMesh(5);
  std::vector<float> values = waveFunction(sphere, 0.0F);
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    if (distance(sphere.points[v], {0.8F, 0.6F, 0.0F}) < 0.1F ||
        distance(sphere.points[v], {-0.6F, 0.0F, 0.8F}) < 0.1F) {
      values[v] = -values[v];
    }
  }
  const Traced traced = trace(buildMeshGraph(sphere.points, sphere.triangles), sphere.triangles, values);
  ASSERT_EQ(traced.axis.size(), 1U);
  EXPECT_EQ(traced.axis[0].points, traceMesh(sphere, 0.0F).axis[0].points);
}

TEST(AxisOfCloud, IsOneClosedCurveOnASphere)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Surface cloud = sphereCloud(4000, seed);
    const Traced traced = traceCloud(cloud, 0.1F);
    ASSERT_EQ(traced.axis.size(), 1U);
    EXPECT_TRUE(traced.axis[0].closed);
    EXPECT_GT(length(traced.graph, traced.axis[0]), 2.0F * 3.14159F * 0.97F);
    EXPECT_LT(length(traced.graph, traced.axis[0]), 2.0F * 3.14159F * 1.15F);
    for (const Index v : traced.axis[0].points) {
      EXPECT_NEAR(cloud.points[v][0], 0.1F, 0.12F);
    }
  }
}

TEST(AxisOfCloud, HasTwoClosedPartsOnATorus)
{
  const Traced traced = traceCloud(torusMesh(120, 40, 2.0F, 0.7F), 0.0F);
  ASSERT_EQ(traced.axis.size(), 2U);
  EXPECT_TRUE(traced.axis[0].closed);
  EXPECT_TRUE(traced.axis[1].closed);
}

TEST(AxisOfCloud, IsOpenOnASheet)
{
  const Surface grid = gridMesh(40, 40);
  const Traced traced = traceCloud(grid, 19.5F);
  ASSERT_EQ(traced.axis.size(), 1U);
  EXPECT_FALSE(traced.axis[0].closed);
  const float first = grid.points[traced.axis[0].points.front()][1];
  const float last = grid.points[traced.axis[0].points.back()][1];
  EXPECT_LE(std::min(first, last), 1.0F);
  EXPECT_GE(std::max(first, last), 38.0F);
}
