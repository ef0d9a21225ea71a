#include "support/shapes.h"
#include "symmetry/surface/open_sides.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

using namespace pcl::symmetry;

namespace {

TEST(OpenSides, AreThoseOfOneTriangleOnly)
{
  // Three triangles share the side from 0 to 1: it is not open.
  const std::vector<OpenSide> sides = openSides(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(sides.size(), 6U);
  for (const OpenSide& side : sides) {
    EXPECT_GT(side.a + side.b, 1);
  }
  EXPECT_TRUE(openSides(6, test::sphereMesh(0).triangles).empty());
}

TEST(OpenSides, RunAsTheirTriangleDoes)
{
  const Surface grid = test::gridMesh(4, 3);
  std::set<std::pair<Index, Index>> directed;
  for (const OpenSide& side : openSides(grid.size(), grid.triangles)) {
    directed.emplace(side.a, side.b);
    const Triangle& t = grid.triangles[side.triangle];
    const std::size_t k = t[0] == side.a ? 0 : t[1] == side.a ? 1 : 2;
    EXPECT_EQ(t[(k + 1) % 3], side.b);
    EXPECT_EQ(t[(k + 2) % 3], side.third);
  }
  EXPECT_EQ(directed.size(), 10U);
  EXPECT_EQ(directed.count({0, 1}), 1U); // below from left to right, above from right to left
  EXPECT_EQ(directed.count({11, 10}), 1U);
}

TEST(OpenPoints, AreVisitedWithAllTheirTriangles)
{
  const Surface grid = test::gridMesh(3, 3);
  const OpenPoints open(grid.size(), grid.triangles, openSides(grid.size(), grid.triangles));
  EXPECT_EQ(open.points(), (std::vector<Index>{0, 1, 2, 3, 5, 6, 7, 8})); // all but the one in the middle
  std::set<std::pair<Index, Index>> around;
  open.visitTriangles(0, [&](Index b, Index c) { around.emplace(b, c); });
  EXPECT_EQ(around, (std::set<std::pair<Index, Index>>{{1, 4}, {4, 3}}));
}

} // namespace
