#include "base/vector_math.h"
#include "symmetry/surface/mesh_cleaning.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(MeshCleaning, LetsTheFirstOfRepeatedPointsStandForAll)
{
  PreparedSurface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  surface.triangles = {{2, 4, 3}};
  surface.original = {10, 11, 12, 13, 14};
  surface.representatives = {no_index, 0, 1, 2, 3, 4};
  mergeRepeatedPoints(surface);
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(surface.original, (std::vector<Index>{10, 11, 13}));
  EXPECT_EQ(surface.representatives, (std::vector<Index>{no_index, 0, 1, 0, 2, 1}));
}

TEST(MeshCleaning, DropsTrianglesWithACornerTwice)
{
  std::vector<Triangle> triangles = {{0, 0, 1}, {0, 1, 2}, {1, 0, 1}, {2, 1, 1}};
  dropDegenerateTriangles(triangles);
  EXPECT_EQ(triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(MeshCleaning, KeepsTheFirstOfTrianglesWithTheSameCorners)
{
  std::vector<Triangle> triangles = {{3, 1, 2}, {0, 1, 2}, {1, 2, 3}, {2, 1, 0}, {0, 1, 3}, {0, 1, 2}};
  dropRepeatedTriangles(4, triangles);
  EXPECT_EQ(triangles, (std::vector<Triangle>{{3, 1, 2}, {0, 1, 2}, {0, 1, 3}}));
}

TEST(MeshCleaning, WeighsTheNormalsOfFacesByTheirAreas)
{
  // Two faces at right angles share an edge; one is three times as large.
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, 0, 1}, {5, 5, 5}};
  const std::vector<Vector3> normals = vertexNormals(points, {{0, 1, 2}, {0, 3, 1}});
  EXPECT_NEAR(distance(normals[0], normalized({0, 1, 3})), 0.0F, 1e-6F);
  EXPECT_EQ(normals[2], (Vector3{0, 0, 1}));
  EXPECT_EQ(normals[3], (Vector3{0, 1, 0}));
  EXPECT_EQ(normals[4], (Vector3{0, 0, 0})); // of no face
}

} // namespace
