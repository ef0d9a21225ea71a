#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "geodesic/surface_graph.h"
#include "symmetry/surface/junction_closing.h"
#include "symmetry/surface/open_sides.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;

namespace {

std::size_t
closeJunctionsOf(PreparedSurface& surface)
{
  return closeJunctions(surface, openSides(surface.size(), surface.triangles));
}

PreparedSurface
meshOf(std::vector<Vector3> points, std::vector<Triangle> triangles)
{
  PreparedSurface surface;
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  return surface;
}

float
areaOf(const PreparedSurface& surface)
{
  float area = 0.0F;
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    area += 0.5F * norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
  }
  return area;
}

/** A triangle above the x axis from 0 to 4, and three below it whose corners on the axis are at 0, 1, 2.5 and 4. */
PreparedSurface
splitBelow(float off)
{
  return meshOf({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {1, off, 0}, {2.5F, -off, 0}, {2, -3, 0}},
                {{0, 1, 2}, {0, 5, 3}, {3, 5, 4}, {4, 5, 1}});
}

TEST(JunctionClosing, CutsATriangleAtTheVerticesOnItsSide)
{
  PreparedSurface surface = splitBelow(1e-6F);
  EXPECT_EQ(closeJunctionsOf(surface), 2U);
  EXPECT_EQ(surface.triangles,
            (std::vector<Triangle>{{0, 3, 2}, {3, 4, 2}, {4, 1, 2}, {0, 5, 3}, {3, 5, 4}, {4, 5, 1}}));
  EXPECT_EQ(openSides(surface.size(), surface.triangles).size(), 4U);
}

TEST(JunctionClosing, LetsDistancesPass)
{
  PreparedSurface surface = splitBelow(0.0F);
  const auto way = [&surface] {
    return distanceField(buildMeshGraph(surface.points, surface.triangles), 3)[2];
  };
  const float around = way();
  closeJunctionsOf(surface);
  EXPECT_GT(around, distance(surface.points[2], surface.points[3]) + 0.5F);
  EXPECT_FLOAT_EQ(way(), distance(surface.points[2], surface.points[3]));
}

TEST(JunctionClosing, CutsAllSidesOfOneTriangle)
{
  // A large triangle, and on each of its sides two small ones that meet in the middle of it.
  std::vector<Vector3> points = {{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {2, 0, 0}, {2, 2, 0},
                                 {0, 2, 0}, {2, -2, 0}, {4, 4, 0}, {-2, 2, 0}};
  PreparedSurface surface =
      meshOf(std::move(points), {{0, 1, 2}, {0, 6, 3}, {3, 6, 1}, {1, 7, 4}, {4, 7, 2}, {2, 8, 5}, {5, 8, 0}});
  const float area = areaOf(surface);
  EXPECT_EQ(closeJunctionsOf(surface), 3U);
  EXPECT_EQ(surface.triangles.size(), 10U);
  EXPECT_FLOAT_EQ(areaOf(surface), area);
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    EXPECT_GT(cross(surface.points[t[1]] - a, surface.points[t[2]] - a)[2], 0.0F) << "turned over";
  }
  EXPECT_EQ(openSides(surface.size(), surface.triangles).size(), 6U);
}

TEST(JunctionClosing, LeavesGapsOpen)
{
  PreparedSurface surface = splitBelow(0.03F);
  EXPECT_EQ(closeJunctionsOf(surface), 0U);
  EXPECT_EQ(surface.triangles.size(), 4U);
}

TEST(JunctionClosing, KeepsSheetsAndTipsApart)
{
  // The second triangle lies over the first, though its vertex 3 is on the side from 0 to 1.
  PreparedSurface sheets =
      meshOf({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {1, 0, 0.001F}, {3, 0, 0.001F}, {2, 2, 0.001F}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(closeJunctionsOf(sheets), 0U);
  PreparedSurface tip =
      meshOf({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 0, 0}, {1, -2, 0}, {3, -2, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(closeJunctionsOf(tip), 0U);
}

TEST(JunctionClosing, DoesNotDependOnTheUnit)
{
  for (const float unit : {1e-25F, 1e25F}) {
    PreparedSurface surface = splitBelow(1e-6F);
    for (Vector3& p : surface.points) {
      p = unit * p;
    }
    EXPECT_EQ(closeJunctionsOf(surface), 2U) << unit;
  }
}

} // namespace
