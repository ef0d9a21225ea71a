#include "cloud/clouds.h"
#include "cloud/local_delaunay.h"
#include "support/shapes.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr double pi = 3.141592653589793;

/** Points of a surface, their normals and graph. */
struct Sampling {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  SurfaceGraph graph;
};

Sampling
withGraph(std::vector<Vector3> points, std::vector<Vector3> normals, int k)
{
  Sampling sampling{std::move(points), std::move(normals), {}};
  sampling.graph = buildNeighbourGraph(sampling.points, nearestNeighbours(sampling.points, k), 0.0F);
  return sampling;
}

Sampling
inPlane(const std::vector<Vector3>& points, int k)
{
  return withGraph(points, std::vector<Vector3>(points.size(), Vector3{0.0F, 0.0F, 1.0F}), k);
}

/** Corners of equilateral triangles of side 1. */
std::vector<Vector3>
triangularLattice(int columns, int rows)
{
  std::vector<Vector3> points;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float shift = j % 2 == 0 ? 0.0F : 0.5F;
      points.push_back({static_cast<float>(i) + shift, static_cast<float>(j) * std::sqrt(0.75F), 0.0F});
    }
  }
  return points;
}

std::vector<Vector3>
irregularGrid(int columns, int rows, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Vector3> points = gridMesh(columns, rows).points;
  for (Vector3& p : points) {
    p = p + Vector3{evenly(random, -0.35F, 0.35F), evenly(random, -0.35F, 0.35F), 0.0F};
  }
  return points;
}

Sampling
onSphere(std::size_t n, float radius)
{
  const std::vector<Vector3> points = sphereCloud(n, radius);
  std::vector<Vector3> normals;
  for (const Vector3& p : points) {
    normals.push_back(normalized(p));
  }
  return withGraph(points, normals, 12);
}

bool
isWithin(const Vector3& p, const Vector3& low, const Vector3& high)
{
  return p[0] > low[0] && p[1] > low[1] && p[0] < high[0] && p[1] < high[1];
}

void
expectSound(const Sampling& sampling, const FanLaplacian& laplacian)
{
  const SurfaceGraph& graph = sampling.graph;
  ASSERT_EQ(laplacian.conductances.size(), graph.neighbours.size());
  ASSERT_EQ(laplacian.areas.size(), sampling.points.size());
  std::size_t conducting = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const auto begin = graph.neighbours.begin() + graph.offsets[graph.neighbours[e]];
      const auto end = graph.neighbours.begin() + graph.offsets[graph.neighbours[e] + 1];
      const auto back = std::find(begin, end, static_cast<Index>(v)) - graph.neighbours.begin();
      ASSERT_EQ(laplacian.conductances[e], laplacian.conductances[static_cast<std::size_t>(back)]);
      ASSERT_GE(laplacian.conductances[e], 0.0F);
      ASSERT_TRUE(std::isfinite(laplacian.conductances[e]));
      conducting += laplacian.conductances[e] > 0.0F ? 1U : 0U;
    }
  }
  EXPECT_GT(conducting, 4 * graph.size());
  double sum = 0.0;
  for (const float area : laplacian.areas) {
    ASSERT_GE(area, 0.0F);
    sum += double{area};
  }
  EXPECT_NEAR(sum, 1.0, 1e-4);
}

double
area(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    sum += 0.5 * double{norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]))};
  }
  return sum;
}

/** Dirichlet energy over mean square of a function whose mean is zero. */
template <typename Function>
double
quotient(const Sampling& sampling, const FanLaplacian& laplacian, Function function)
{
  double energy = 0.0;
  double square = 0.0;
  for (std::size_t v = 0; v < sampling.points.size(); ++v) {
    const double value = function(sampling.points[v]);
    square += double{laplacian.areas[v]} * value * value;
    for (std::uint32_t e = sampling.graph.offsets[v]; e < sampling.graph.offsets[v + 1]; ++e) {
      const double other = function(sampling.points[sampling.graph.neighbours[e]]);
      energy += 0.5 * double{laplacian.conductances[e]} * (value - other) * (value - other);
    }
  }
  return energy / square;
}

TEST(LocalDelaunayLaplacian, IsSymmetricAndNotNegative)
{
  for (const Sampling& sampling : {onSphere(1500, 0.4F), inPlane(irregularGrid(30, 25, 1), 16)}) {
    expectSound(sampling, localDelaunayLaplacian(sampling.points, sampling.normals, sampling.graph));
  }
}

TEST(LocalDelaunayLaplacian, IsThatOfEquilateralTriangles)
{
  const Sampling sampling = inPlane(triangularLattice(16, 16), 18); // with the second neighbours, which conduct nothing
  const FanLaplacian laplacian = localDelaunayLaplacian(sampling.points, sampling.normals, sampling.graph);
  float inner_area = 0.0F;
  std::size_t inner = 0;
  for (std::size_t v = 0; v < sampling.points.size(); ++v) {
    if (!isWithin(sampling.points[v], {2.9F, 2.5F, 0.0F}, {12.6F, 10.4F, 0.0F})) {
      continue;
    }
    ++inner;
    for (std::uint32_t e = sampling.graph.offsets[v]; e < sampling.graph.offsets[v + 1]; ++e) {
      const float expected =
          sampling.graph.lengths[e] < 1.1F ? 1.0F / std::sqrt(3.0F) : 0.0F; // cotangent of 60 degrees
      ASSERT_NEAR(laplacian.conductances[e], expected, 1e-4F);
    }
    inner_area = inner_area == 0.0F ? laplacian.areas[v] : inner_area;
    ASSERT_NEAR(laplacian.areas[v], inner_area, 1e-3F * inner_area);
  }
  EXPECT_GT(inner, 60U);
}

TEST(LocalDelaunayLaplacian, OfALinearFunctionInThePlaneIsZero)
{
  const Sampling sampling = inPlane(irregularGrid(30, 30, 2), 20);
  const FanLaplacian laplacian = localDelaunayLaplacian(sampling.points, sampling.normals, sampling.graph);
  double worst = 0.0;
  double conductance = 0.0;
  for (std::size_t v = 0; v < sampling.points.size(); ++v) {
    if (isWithin(sampling.points[v], {4.0F, 4.0F, 0.0F}, {25.0F, 25.0F, 0.0F})) {
      Vector3 sum{0.0F, 0.0F, 0.0F};
      for (std::uint32_t e = sampling.graph.offsets[v]; e < sampling.graph.offsets[v + 1]; ++e) {
        sum = sum + laplacian.conductances[e] * (sampling.points[sampling.graph.neighbours[e]] - sampling.points[v]);
        conductance = std::max(conductance, double{laplacian.conductances[e]});
      }
      worst = std::max(worst, double{norm(sum)});
    }
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(conductance, 1.0);
}

TEST(LocalDelaunayLaplacian, HasTheEigenvaluesOfTheSphere)
{
  // The eigenvalues l (l + 1) / r^2 times the area 4 pi r^2, as the areas sum up to 1: the same for every radius.
  for (const float radius : {0.4F, 3.0F}) {
    const Sampling sampling = onSphere(2500, radius);
    const FanLaplacian laplacian = localDelaunayLaplacian(sampling.points, sampling.normals, sampling.graph);
    for (std::size_t k = 0; k < 3; ++k) {
      const double linear = quotient(sampling, laplacian, [k](const Vector3& p) { return double{p[k]}; });
      EXPECT_NEAR(linear / (2.0 * 4.0 * pi), 1.0, 0.01);
      const double product =
          quotient(sampling, laplacian, [k](const Vector3& p) { return double{p[k]} * double{p[(k + 1) % 3]}; });
      EXPECT_NEAR(product / (6.0 * 4.0 * pi), 1.0, 0.02);
    }
  }
}

TEST(LocalDelaunayLaplacian, AreasFollowTheDensity)
{
  // A sphere with one half sampled four times as densely: each half has half of the area.
  std::vector<Vector3> points;
  for (const Vector3& p : sphereCloud(4000, 0.4F)) {
    if (p[0] > 0.0F) {
      points.push_back(p);
    }
  }
  for (const Vector3& p : sphereCloud(1000, 0.4F)) {
    if (p[0] <= 0.0F) {
      points.push_back(p);
    }
  }
  std::vector<Vector3> normals;
  for (const Vector3& p : points) {
    normals.push_back(normalized(p));
  }
  const Sampling sampling = withGraph(points, normals, 16);
  const FanLaplacian laplacian = localDelaunayLaplacian(sampling.points, sampling.normals, sampling.graph);
  double dense = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    dense += points[v][0] > 0.0F ? double{laplacian.areas[v]} : 0.0;
  }
  EXPECT_NEAR(dense, 0.5, 0.02);
}

TEST(LocalDelaunayLaplacian, OfUnconnectedPointsHasEqualAreas)
{
  const std::vector<Vector3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const FanLaplacian laplacian =
      localDelaunayLaplacian(points, std::vector<Vector3>(4, Vector3{0.0F, 0.0F, 1.0F}), buildGraph(4, {}));
  EXPECT_EQ(laplacian.areas, std::vector<float>(4, 0.25F));
  EXPECT_TRUE(laplacian.conductances.empty());
  EXPECT_TRUE(laplacian.triangles.empty());
}

TEST(LocalDelaunayTriangles, CoverTheSphereOnceFacingOutwards)
{
  const Sampling sampling = onSphere(2500, 0.4F);
  const std::vector<Triangle> triangles = localDelaunayTriangles(sampling.points, sampling.normals, sampling.graph);
  EXPECT_NEAR(area(sampling.points, triangles) / (4.0 * pi * 0.16), 1.0, 0.02);
  EXPECT_NEAR(static_cast<double>(triangles.size()) / (2.0 * 2500.0 - 4.0), 1.0, 0.02); // Euler
  for (const Triangle& t : triangles) {
    const Vector3& corner = sampling.points[t[0]];
    ASSERT_GT(dot(cross(sampling.points[t[1]] - corner, sampling.points[t[2]] - corner), corner), 0.0F);
    ASSERT_TRUE(t[0] < t[1] && t[0] < t[2]);
  }
  EXPECT_EQ(std::adjacent_find(triangles.begin(), triangles.end()), triangles.end());
  EXPECT_EQ(withThreads(3, [&] { return localDelaunayTriangles(sampling.points, sampling.normals, sampling.graph); }),
            triangles);
}

TEST(ConformingTriangles, CoverALatticeOnce)
{
  constexpr int size = 12;
  std::vector<Vector3> lattice;
  std::vector<Index> all;
  for (int i = 0; i < size * size; ++i) {
    lattice.push_back({static_cast<float>(i % size), static_cast<float>(i / size), 0.0F});
    all.push_back(i);
  }
  const Sampling sampling = inPlane(lattice, 8);
  EXPECT_LT(localDelaunayTriangles(sampling.points, sampling.normals, sampling.graph).size(),
            static_cast<std::size_t>(size * size))
      << "fans that agree would be enough";
  const std::vector<Triangle> triangles = conformingTriangles(sampling.points, sampling.normals, sampling.graph, all);
  EXPECT_EQ(triangles.size(), 2U * (size - 1) * (size - 1));
  EXPECT_NEAR(area(sampling.points, triangles), (size - 1.0) * (size - 1.0), 1e-3);
}

TEST(ConformingTriangles, ShareNoSideButFromItsTwoSides)
{
  const Sampling sampling = onSphere(2500, 0.4F);
  std::vector<Index> all(sampling.points.size());
  std::iota(all.begin(), all.end(), 0);
  std::map<std::pair<Index, Index>, int> sides;
  const std::vector<Triangle> triangles = conformingTriangles(sampling.points, sampling.normals, sampling.graph, all);
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  for (const auto& [side, count] : sides) {
    ASSERT_LE(count, 2);
  }
  EXPECT_NEAR(area(sampling.points, triangles) / (4.0 * pi * 0.16), 1.0, 0.02);
}

TEST(LocalDelaunayTriangles, HaveNoPointInTheirCircles)
{
  const Sampling sampling = inPlane(irregularGrid(20, 20, 3), 20);
  std::size_t inner = 0;
  for (const Triangle& t : localDelaunayTriangles(sampling.points, sampling.normals, sampling.graph)) {
    const Vector3& a = sampling.points[t[0]];
    if (!isWithin(a, {4.0F, 4.0F, 0.0F}, {15.0F, 15.0F, 0.0F})) {
      continue;
    }
    ++inner;
    const Vector3 b = sampling.points[t[1]] - a;
    const Vector3 c = sampling.points[t[2]] - a;
    const float turn = 2.0F * (b[0] * c[1] - b[1] * c[0]);
    const Vector3 centre{(c[1] * dot(b, b) - b[1] * dot(c, c)) / turn, (b[0] * dot(c, c) - c[0] * dot(b, b)) / turn,
                         0.0F};
    for (const Vector3& p : sampling.points) {
      ASSERT_GT(distance(p, a + centre), norm(centre) - 1e-3F);
    }
  }
  EXPECT_GT(inner, 200U);
}

} // namespace
