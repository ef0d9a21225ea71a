#include "base/statistics.h"
#include "base/vector_math.h"
#include "geodesic/neighbour_graph.h"
#include "support/prepared.h"
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
length(const Polyline& line)
{
  return line.curve.back().arc_length +
         (line.closed ? distance(line.curve.back().position, line.curve.front().position) : 0.0F);
}

/** What holds for every axis: neighbours follow each other, or on a cloud points two edges apart, where a triangle is
 * missing; none twice, longest first; directions are at right angles, across points to the source side. */
void
expectWellFormed(const PreparedSurface& surface, const std::vector<Polyline>& axis)
{
  const float longest_gap = surface.is_cloud ? 2.0F * median(surface.graph.lengths) : 0.0F;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const std::vector<Index>& points = axis[i].points;
    for (std::size_t k = axis[i].closed ? 0 : 1; k < points.size(); ++k) {
      const Index before = points[(k + points.size() - 1) % points.size()];
      EXPECT_TRUE(areNeighbours(surface.graph, before, points[k]) ||
                  distance(surface.points[before], surface.points[points[k]]) <= longest_gap)
          << "a step that is no edge";
    }
    EXPECT_EQ(std::set<Index>(points.begin(), points.end()).size(), points.size()) << "a vertex twice";
    for (const AxisPoint& place : axis[i].curve) {
      EXPECT_NEAR(dot(place.across, place.normal), 0.0F, 1e-4F);
      EXPECT_NEAR(norm(place.across), 1.0F, 1e-3F);
      EXPECT_GT(place.across[0], 0.5F) << "the source side is where x is large";
    }
    if (i > 0) {
      EXPECT_LE(length(axis[i]), 1.01F * length(axis[i - 1]));
    }
  }
}

struct Traced {
  PreparedSurface surface;
  std::vector<Polyline> axis;
};

Traced
trace(PreparedSurface surface, const std::vector<float>& values)
{
  Traced traced;
  const std::vector<float> side_function = absorbSpecks(surface.graph, values);
  traced.axis = traceAxis(surface, side_function, {}, false);
  traced.surface = std::move(surface);
  return traced;
}

PreparedSurface
withNormals(const Surface& mesh)
{
  PreparedSurface surface = prepared(mesh);
  surface.normals.assign(mesh.size(), Vector3{});
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      surface.normals[v] =
          surface.normals[v] + cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    }
  }
  std::transform(surface.normals.begin(), surface.normals.end(), surface.normals.begin(), unitOrZero);
  return surface;
}

Traced
traceMesh(const Surface& mesh, float offset)
{
  Traced traced = trace(withNormals(mesh), waveFunction(mesh, offset));
  expectWellFormed(traced.surface, traced.axis);
  return traced;
}

/** The points of a surface as a cloud. */
PreparedSurface
preparedCloud(const Surface& mesh)
{
  PreparedSurface cloud = mesh.hasFaces() ? withNormals(mesh) : prepared(mesh);
  if (!mesh.hasFaces()) {
    cloud.normals = mesh.points; // of a sphere
  }
  cloud.graph = cloudGraph(mesh.points, 10);
  cloud.is_cloud = true;
  return cloud;
}

Traced
traceCloud(const Surface& surface, float offset)
{
  Traced traced = trace(preparedCloud(surface), waveFunction(surface, offset));
  expectWellFormed(traced.surface, traced.axis);
  return traced;
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
  // At most 4 % more than the circle: no zigzag of edges, which is up to 2 / sqrt (3) on equilateral triangles.
  EXPECT_GT(length(traced.axis[0]), 2.0F * 3.14159F * 0.99F);
  EXPECT_LT(length(traced.axis[0]), 2.0F * 3.14159F * 1.04F);
  for (const AxisPoint& place : traced.axis[0].curve) {
    const Vector3& p = place.position;
    EXPECT_NEAR(p[0] - 0.1F + 0.03F * std::sin(9.0F * p[1] + 4.0F * p[2]), 0.0F, 2e-3F) << "off the zero";
    EXPECT_LT(distance(p, sphere.points[place.nearest]), 0.05F);
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

TEST(AxisOfMesh, ShortLinesAreToldWhereTheSidesAreExact)
{
  Surface object = sphereMesh(5);
  const Surface knob = sphereMesh(2);
  const auto first = static_cast<Index>(object.size());
  for (const Vector3& p : knob.points) {
    object.points.push_back(0.04F * p + Vector3{0.0F, 1.03F, 0.0F});
  }
  for (const Triangle& t : knob.triangles) {
    object.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  std::vector<float> heights;
  for (const Vector3& p : object.points) {
    heights.push_back(p[0] - 0.001F);
  }
  const PreparedSurface surface = withNormals(object);
  const std::vector<float> values = withoutZeros(surface.graph, heights);
  EXPECT_EQ(traceAxis(surface, values, {}, false).size(), 1U);
  const std::vector<Polyline> axis = traceAxis(surface, values, {}, true);
  ASSERT_EQ(axis.size(), 2U);
  EXPECT_TRUE(axis[1].closed);
  EXPECT_NEAR(length(axis[1]), 0.04F * 2.0F * 3.14159F, 0.01F);
}

TEST(AxisOfMesh, EndsAtTheBoundary)
{
  const Surface grid = gridMesh(30, 20);
  const Traced traced = traceMesh(grid, 14.5F);
  ASSERT_EQ(traced.axis.size(), 1U);
  EXPECT_FALSE(traced.axis[0].closed);
  const float first = traced.axis[0].curve.front().position[1];
  const float last = traced.axis[0].curve.back().position[1];
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
  const Traced traced = trace(prepared(sheets), values);
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
  EXPECT_TRUE(trace(preparedCloud(sphere), std::vector<float>(sphere.size(), 1.0F)).axis.empty());
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
  const Traced traced = trace(prepared(sphere), values);
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
    EXPECT_GT(length(traced.axis[0]), 2.0F * 3.14159F * 0.97F);
    EXPECT_LT(length(traced.axis[0]), 2.0F * 3.14159F * 1.05F);
    for (const AxisPoint& place : traced.axis[0].curve) {
      EXPECT_NEAR(place.position[0], 0.1F, 0.03F + 0.05F); // the wave, and an edge where a hole is bridged
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

TEST(AxisOfCloud, GoesOnOverAGapOfTheCloud)
{
  Surface cloud = sphereCloud(4000, 4);
  const auto in_gap = [](const Vector3& p) {
    return p[1] > 0.0F && std::abs(p[2]) < 0.06F && std::abs(p[0]) < 0.06F;
  };
  cloud.points.erase(std::remove_if(cloud.points.begin(), cloud.points.end(), in_gap), cloud.points.end());
  std::transform(cloud.points.begin(), cloud.points.end(), cloud.points.begin(),
                 [](const Vector3& p) { return 0.5F * p; }); // at unit size, as prepared surfaces are
  const std::vector<Polyline> axis = trace(preparedCloud(cloud), waveFunction(cloud, 0.0F)).axis;
  ASSERT_EQ(axis.size(), 1U);
  EXPECT_TRUE(axis[0].closed);
}

TEST(Axis, LeavesOutWhatIsNotWanted)
{
  const Surface sphere = sphereMesh(5);
  for (const PreparedSurface& surface : {withNormals(sphere), preparedCloud(sphere)}) {
    std::vector<char> is_out;
    for (const Vector3& p : sphere.points) {
      is_out.push_back(p[2] > 0.5F ? 1 : 0);
    }
    const std::vector<Polyline> axis =
        traceAxis(surface, absorbSpecks(surface.graph, waveFunction(sphere, 0.0F)), is_out, false);
    ASSERT_EQ(axis.size(), 1U);
    EXPECT_FALSE(axis[0].closed);
    EXPECT_NEAR(length(axis[0]), 3.14159F * 4.0F / 3.0F, 0.2F); // two thirds of the circle
    for (const AxisPoint& place : axis[0].curve) {
      EXPECT_LE(place.position[2], 0.55F);
    }
  }
}
