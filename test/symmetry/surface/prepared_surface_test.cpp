#include "base/vector_math.h"
#include "support/graphs.h"
#include "support/prepared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(PreparedSurface, LongestSideIsOneAndTheBoxIsCentred)
{
  for (const float scale : {1e-30F, 1.0F, 1e36F}) {
    const Surface mesh = scaled(sphereMesh(3), {scale, 0.5F * scale, 0.25F * scale});
    const PreparedSurface prepared = preparedMesh(mesh);
    ASSERT_EQ(prepared.size(), mesh.size());
    Vector3 low{9, 9, 9};
    Vector3 high{-9, -9, -9};
    for (const Vector3& p : prepared.points) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    EXPECT_NEAR(distance(high, {0.5F, 0.25F, 0.125F}), 0.0F, 1e-5F);
    EXPECT_NEAR(distance(low, {-0.5F, -0.25F, -0.125F}), 0.0F, 1e-5F);
    EXPECT_NEAR(prepared.scale * scale, 0.5F, 1e-5F);
  }
}

TEST(PreparedSurface, KeepsTheLargestComponentInItsOrder)
{
  Surface mesh;
  mesh.points = {{5, 5, 5}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}};
  const Surface grid = gridMesh(7, 5);
  mesh.points.insert(mesh.points.end(), grid.points.begin(), grid.points.end());
  for (const Triangle& t : grid.triangles) {
    mesh.triangles.push_back({t[0] + 2, t[1] + 2, t[2] + 2});
  }
  mesh.triangles.push_back({1, 2, 3}); // of a point that is dropped
  mesh.triangles.push_back({4, 4, 5}); // degenerate
  const PreparedSurface prepared = preparedMesh(mesh);
  ASSERT_EQ(prepared.size(), grid.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_EQ(prepared.original[v], static_cast<Index>(v) + 2);
  }
  EXPECT_EQ(prepared.triangles, grid.triangles);
  EXPECT_EQ(prepared.summary.points, 37U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.unused, 1U);
  EXPECT_EQ(prepared.summary.used, grid.size());
}

TEST(PreparedSurface, APointFarAwayThatNoFaceUsesChangesNothing)
{
  const Surface sphere = sphereMesh(3);
  Surface more = sphere;
  more.points.push_back({1e30F, 0, 0});
  const PreparedSurface prepared = preparedMesh(more);
  EXPECT_EQ(prepared.points, preparedMesh(sphere).points);
  EXPECT_EQ(prepared.summary.unused, 1U);
}

TEST(PreparedSurface, AComponentFarAwayCostsNoPrecision)
{
  const Surface sphere = sphereMesh(4);
  const PreparedSurface expected = preparedMesh(sphere);
  Surface mesh = sphere;
  const auto n = static_cast<Index>(mesh.size());
  mesh.points.insert(mesh.points.end(), {{1e7F, 0, 0}, {1e7F, 1, 0}, {1e7F, 0, 1}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  const PreparedSurface prepared = preparedMesh(mesh);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.summary.other_components, 3U);
}

TEST(PreparedSurface, FacesThatComeTwiceAreTakenOnce)
{
  const Surface grid = gridMesh(7, 5);
  Surface doubled = grid;
  for (const Triangle& t : grid.triangles) {
    doubled.triangles.push_back({t[1], t[2], t[0]});
    doubled.triangles.push_back({t[2], t[1], t[0]}); // as the back of a two-sided surface
  }
  EXPECT_EQ(preparedMesh(doubled).triangles, grid.triangles);
}

/** As exporters write textures: every face with corners of its own. */
TEST(PreparedSurface, VerticesThatAreRepeatedForEveryFaceAreOne)
{
  const Surface mesh = gridMesh(7, 5);
  Surface soup;
  for (const Triangle& t : mesh.triangles) {
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<Index>(soup.points.size());
      soup.points.push_back(mesh.points[t[k]]);
    }
    soup.triangles.push_back(corners);
  }
  const PreparedSurface prepared = preparedMesh(soup);
  ASSERT_EQ(prepared.size(), mesh.size());
  EXPECT_EQ(prepared.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.used, soup.size());
  const Vector3 origin =
      prepared.points[0] - prepared.scale * soup.points[static_cast<std::size_t>(prepared.original[0])];
  for (std::size_t v = 0; v < soup.size(); ++v) {
    const Vector3& stands_for_it = prepared.points[static_cast<std::size_t>(prepared.representatives[v])];
    EXPECT_LT(distance(stands_for_it, origin + prepared.scale * soup.points[v]), 1e-6F);
  }
}

TEST(PreparedSurface, GraphIsThatOfTheMeshAtItsScale)
{
  const Surface grid = gridMesh(7, 5);
  const PreparedSurface prepared = preparedMesh(grid);
  const SurfaceGraph expected = meshGraph(grid);
  EXPECT_FLOAT_EQ(prepared.scale, 1.0F / 6.0F);
  EXPECT_EQ(prepared.graph.offsets, expected.offsets);
  EXPECT_EQ(prepared.graph.neighbours, expected.neighbours);
  for (std::size_t e = 0; e < expected.lengths.size(); ++e) {
    EXPECT_NEAR(prepared.graph.lengths[e], expected.lengths[e] / 6.0F, 1e-6F);
  }
}

TEST(PreparedSurface, NormalsOfASpherePointOutwards)
{
  const PreparedSurface prepared = preparedMesh(sphereMesh(4));
  ASSERT_EQ(prepared.normals.size(), prepared.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_GT(dot(prepared.normals[v], normalized(prepared.points[v])), 0.999F);
    EXPECT_NEAR(norm(prepared.normals[v]), 1.0F, 1e-5F);
  }
}

/** A sphere of which one octant was left coarse, every triangle with corners of its own, which rounding has moved. */
TEST(PreparedSurface, CracksDoNotTearASurface)
{
  Surface sphere = sphereMesh(0);
  sphere = scaled(sphere, {1.0F, 0.8F, 0.6F});
  Surface facets;
  const auto add = [&facets](const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto first = static_cast<Index>(facets.size());
    for (const Vector3& p : {a, b, c}) {
      const float off = 1e-6F * static_cast<float>(facets.size() % 7);
      facets.points.push_back({p[0] + off, p[1] - off, p[2] + off});
    }
    facets.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    const Vector3 a = sphere.points[sphere.triangles[i][0]];
    const Vector3 b = sphere.points[sphere.triangles[i][1]];
    const Vector3 c = sphere.points[sphere.triangles[i][2]];
    if (i == 0) {
      add(a, b, c);
      continue;
    }
    const Vector3 ab = 0.5F * (a + b);
    const Vector3 bc = 0.5F * (b + c);
    const Vector3 ca = 0.5F * (c + a);
    add(a, ab, ca);
    add(ab, b, bc);
    add(ca, bc, c);
    add(ab, bc, ca);
  }
  const PreparedSurface prepared = preparedMesh(facets);
  EXPECT_EQ(prepared.size(), 18U);
  EXPECT_EQ(prepared.summary.welded, facets.size() - 18U);
  EXPECT_EQ(prepared.summary.junctions, 3U);
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.used, facets.size());
  for (const Vector3& p : facets.points) {
    const Index v = prepared.representatives[static_cast<std::size_t>(&p - facets.points.data())];
    EXPECT_LT(distance(prepared.points[v], prepared.scale * p), 1e-4F);
  }
}

} // namespace
