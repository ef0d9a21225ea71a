#include "base/vector_math.h"
#include "support/graphs.h"
#include "support/shapes.h"
#include "symmetry/mirror/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

PreparedSurface
grid(bool is_cloud)
{
  const Surface mesh = gridMesh(11, 11); // in the plane z = 0, spaced by 1
  PreparedSurface surface;
  surface.points = mesh.points;
  surface.normals.assign(mesh.size(), {0, 0, 1});
  surface.graph = meshGraph(mesh);
  surface.is_cloud = is_cloud;
  if (!is_cloud) {
    surface.triangles = mesh.triangles;
  }
  return surface;
}

TEST(SurfaceDistance, OfAMeshIsThatFromItsTriangles)
{
  const PreparedSurface mesh = grid(false);
  const SurfaceDistance distance_from(mesh, 3.0F);
  EXPECT_NEAR(distance_from.at({4.3F, 5.6F, 0.0F}), 0.0F, 1e-6F);
  EXPECT_NEAR(distance_from.at({4.3F, 5.6F, -1.5F}), 1.5F, 1e-6F);
  EXPECT_NEAR(distance_from.at({-1.0F, 5.5F, 0.0F}), 1.0F, 1e-6F);             // beyond a border
  EXPECT_NEAR(distance_from.at({-1.0F, -1.0F, 1.0F}), std::sqrt(3.0F), 1e-5F); // beyond a corner
}

TEST(SurfaceDistance, IsInfiniteBeyondTheReach)
{
  const PreparedSurface mesh = grid(false);
  const SurfaceDistance distance_from(mesh, 0.5F);
  // Over the middle of a triangle: those wider than any of a split surface are only met there.
  EXPECT_TRUE(std::isfinite(distance_from.at({5.33F, 5.33F, 0.49F})));
  EXPECT_TRUE(std::isinf(distance_from.at({5.33F, 5.33F, 0.51F})));
}

TEST(SurfaceDistance, OfACloudIsThatFromThePlanesOfItsPoints)
{
  const PreparedSurface cloud = grid(true);
  const SurfaceDistance distance_from(cloud, 3.0F);
  EXPECT_NEAR(distance_from.at({4.3F, 5.6F, 0.2F}), 0.2F, 1e-6F);  // between points
  EXPECT_NEAR(distance_from.at({-2.5F, 5.0F, 0.0F}), 2.5F, 1e-6F); // no plane reaches as far
}

} // namespace
