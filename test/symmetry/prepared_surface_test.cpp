#include "geodesic/vector_math.h"
#include "support/graphs.h"
#include "symmetry/prepared_surface.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

PreparedSurface
prepare(const Surface& mesh)
{
  return prepareSurface(mesh, SymmetryParameters{}, NeighbourSearch{});
}

TEST(PreparedSurface, LongestSideIsOneAndTheBoxIsCentred)
{
  for (const float scale : {1e-30F, 1.0F, 1e36F}) {
    const Surface mesh = scaled(sphereMesh(3), {scale, 0.5F * scale, 0.25F * scale});
    const PreparedSurface prepared = prepare(mesh);
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
  const PreparedSurface prepared = prepare(mesh);
  ASSERT_EQ(prepared.size(), grid.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_EQ(prepared.original[v], static_cast<Index>(v) + 2);
  }
  EXPECT_EQ(prepared.triangles, grid.triangles);
  EXPECT_EQ(prepared.summary.points, 37U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
  EXPECT_EQ(prepared.summary.components, 2U);
  EXPECT_EQ(prepared.summary.other_components, 1U);
  EXPECT_EQ(prepared.summary.used, grid.size());
}

TEST(PreparedSurface, GraphIsThatOfTheMeshAtItsScale)
{
  const Surface grid = gridMesh(7, 5);
  const PreparedSurface prepared = prepare(grid);
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
  const PreparedSurface prepared = prepare(sphereMesh(4));
  ASSERT_EQ(prepared.normals.size(), prepared.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_GT(dot(prepared.normals[v], normalized(prepared.points[v])), 0.999F);
    EXPECT_NEAR(norm(prepared.normals[v]), 1.0F, 1e-5F);
  }
}

} // namespace
