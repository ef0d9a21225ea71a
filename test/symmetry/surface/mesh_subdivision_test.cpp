#include "base/vector_math.h"
#include "support/boxes.h"
#include "support/known_body.h"
#include "support/prepared.h"
#include "support/shapes.h"
#include "symmetry/surface/mesh_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

float
longestSide(const PreparedSurface& surface)
{
  float longest = 0.0F;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, distance(surface.points[t[k]], surface.points[t[(k + 1) % 3]]));
    }
  }
  return longest;
}

Surface
asSurface(const PreparedSurface& surface)
{
  Surface mesh;
  mesh.points = surface.points;
  mesh.triangles = surface.triangles;
  return mesh;
}

TEST(MeshSubdivision, SplitsUntilNoSideIsLongerThanWantedAndKeepsTheArea)
{
  const Surface chair = chairOfBoxes();
  PreparedSurface surface = prepared(chair);
  const float spacing = evenSpacing(surface, 3000);
  const std::size_t added = splitLongSides(surface, 3000);
  EXPECT_EQ(surface.size(), chair.size() + added);
  EXPECT_GT(surface.size(), 3000U);
  EXPECT_LE(longestSide(surface), 2.0F * spacing); // unless slivers took too many points: then half as far
  EXPECT_NEAR(surfaceArea(asSurface(surface)), surfaceArea(chair), 1e-4);
  EXPECT_EQ(surface.unsplit, chair.triangles);
  EXPECT_EQ(surface.original.size(), surface.size());
}

TEST(MeshSubdivision, TellsOfANewPointWhatIsAtOneNearBy)
{
  const Surface sphere = sphereMesh(3);
  PreparedSurface surface = prepared(sphere);
  ASSERT_GT(splitLongSides(surface, 2000), 0U);
  for (std::size_t v = sphere.size(); v < surface.size(); ++v) {
    EXPECT_LT(distance(surface.points[v], sphere.points[surface.original[v]]), 0.3F); // half of a side of the sphere
  }
}

TEST(MeshSubdivision, LeavesNoCornerOfATriangleOnTheSideOfAnother)
{
  // Every side of a closed mesh belongs to two triangles, before and after.
  PreparedSurface surface = prepared(sphereMesh(2));
  splitLongSides(surface, 500);
  std::vector<std::pair<Index, Index>> sides;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sides.emplace_back(t[k], t[(k + 1) % 3]);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [a, b] : sides) {
    EXPECT_TRUE(std::binary_search(sides.begin(), sides.end(), std::make_pair(b, a)));
  }
  EXPECT_EQ(std::adjacent_find(sides.begin(), sides.end()), sides.end());
}

TEST(MeshSubdivision, LeavesAFineMeshAlone)
{
  PreparedSurface surface = prepared(sphereMesh(4));
  const std::vector<Triangle> before = surface.triangles;
  EXPECT_EQ(splitLongSides(surface, 1000), 0U);
  EXPECT_EQ(surface.triangles, before);
  EXPECT_TRUE(surface.unsplit.empty());
}

TEST(MeshSubdivision, LeavesAloneWhatHasNoShapeOrNoArea)
{
  PreparedSurface box = prepared({});
  EXPECT_EQ(splitLongSides(box, 1000), 0U);
  Surface eight;
  addBox(eight, {0, 0, 0}, {1, 1, 1});
  box = prepared(eight);
  EXPECT_EQ(splitLongSides(box, 1000), 0U);
  PreparedSurface flat = prepared(scaled(sphereMesh(3), {1, 0, 0}));
  EXPECT_EQ(splitLongSides(flat, 1000), 0U);
}

} // namespace
