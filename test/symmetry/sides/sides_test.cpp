#include "support/graphs.h"
#include "symmetry/sides/sides.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A chain of vertices, one apart. */
SurfaceGraph
chain(Index n)
{
  std::vector<GraphEdge> edges;
  for (Index v = 1; v < n; ++v) {
    edges.push_back({v - 1, v, 1.0F});
  }
  return buildGraph(static_cast<std::size_t>(n), edges);
}

} // namespace

TEST(SideFunction, CountsThePairsWhoseEndsAreNearer)
{
  const SurfaceGraph graph = chain(7);
  // Two pairs that agree and one the other way round.
  const std::vector<float> side = sideFunction(distanceFields(graph, {0, 1, 5}), distanceFields(graph, {6, 5, 0}));
  for (const Index v : {0, 1, 2}) {
    EXPECT_NEAR(side[v], 1.0 / 3.0, 0.15) << v;
  }
  for (const Index v : {4, 5, 6}) {
    EXPECT_NEAR(side[v], -1.0 / 3.0, 0.15) << v;
  }
}

TEST(SideFunction, IsOneAtTheSourcesAndChangesItsSignWithThePairs)
{
  const SurfaceGraph graph = meshGraph(gridMesh(15, 6));
  const DistanceFields left = distanceFields(graph, {0, 15, 75});
  const DistanceFields right = distanceFields(graph, {14, 29, 89});
  const std::vector<float> side = sideFunction(left, right);
  const std::vector<float> opposite = sideFunction(right, left);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    EXPECT_EQ(side[v], -opposite[v]);
    EXPECT_LE(std::abs(side[v]), 1.0F);
    const std::size_t column = v % 15;
    if (column < 3) {
      EXPECT_GT(side[v], 0.9F);
    }
    if (column > 11) {
      EXPECT_LT(side[v], -0.9F);
    }
  }
}

TEST(SideFunction, LetsTheDistancesDecideADraw)
{
  const SurfaceGraph graph = chain(9);
  // Between 2 and 6 the pairs disagree; the first one is much clearer at 3.
  const std::vector<float> side = sideFunction(distanceFields(graph, {2, 8}), distanceFields(graph, {6, 0}));
  EXPECT_GT(side[3], 0.0F);
  EXPECT_LT(side[5], 0.0F);
  EXPECT_EQ(side[4], 0.0F);
  EXPECT_LT(std::abs(side[3]), 0.5F);
}

TEST(SideFunction, IsZeroWhereNoPairVotes)
{
  const SurfaceGraph graph = buildGraph(3, {{0, 1, 1.0F}});
  const std::vector<float> side = sideFunction(distanceFields(graph, {0}), distanceFields(graph, {1}));
  EXPECT_GT(side[0], 0.0F);
  EXPECT_EQ(side[2], 0.0F);
  DistanceFields none;
  none.columns = 3;
  EXPECT_EQ(sideFunction(none, none), std::vector<float>(3, 0.0F));
}

TEST(AbsorbSpecks, TurnsSmallPatchesEvenOneWithinAnother)
{
  const SurfaceGraph graph = meshGraph(gridMesh(60, 60));
  std::vector<float> side(3600);
  for (int v = 0; v < 3600; ++v) {
    side[v] = v % 60 < 30 ? 0.5F : -0.5F;
  }
  const std::vector<float> clean = side;
  for (int j = 10; j < 17; ++j) { // 49 vertices within the source side
    for (int i = 10; i < 17; ++i) {
      side[j * 60 + i] = -0.5F;
    }
  }
  side[13 * 60 + 13] = 0.5F;
  EXPECT_EQ(absorbSpecks(graph, side), clean);
}

TEST(AbsorbSpecks, LeavesLargePatchesAndTheLargestOfASmallSide)
{
  const SurfaceGraph graph = meshGraph(gridMesh(20, 20));
  std::vector<float> side(400, 1.0F);
  side[45] = -1.0F; // the only vertex of its side
  EXPECT_EQ(absorbSpecks(graph, side), side);
  for (int v = 0; v < 400; ++v) { // three stripes
    side[v] = v % 20 < 5 || v % 20 > 14 ? -1.0F : 1.0F;
  }
  EXPECT_EQ(absorbSpecks(graph, side), side);
}

TEST(AbsorbSpecks, LeavesNoZero)
{
  const std::vector<float> side = absorbSpecks(chain(7), {1.0F, 0.0F, 1.0F, 0.0F, -1.0F, 0.0F, -1.0F});
  EXPECT_GT(side[1], 0.0F);
  EXPECT_NE(side[3], 0.0F);
  EXPECT_LT(side[5], 0.0F);
}

TEST(LabelSides, GoesByTheSign)
{
  EXPECT_EQ(labelSides({0.5F, -0.1F, 0.1F}), (std::vector<Side>{Side::Source, Side::Target, Side::Source}));
}

TEST(MarkAxis, MarksTheNearerEndWhereTheSignChanges)
{
  const std::vector<float> values{0.5F, 0.3F, 0.1F, -0.2F, -0.3F, -1.0F};
  std::vector<Side> sides = labelSides(values);
  markAxis(chain(6), values, {}, sides);
  EXPECT_EQ(sides,
            (std::vector<Side>{Side::Source, Side::Source, Side::Axis, Side::Target, Side::Target, Side::Target}));
}

TEST(MarkAxis, MarksPartnersTogether)
{
  const std::vector<float> values{0.5F, 0.3F, 0.1F, -0.2F, -0.3F, -1.0F};
  std::vector<Side> sides = labelSides(values);
  markAxis(chain(6), values, {5, 4, 3, 2, 1, 0}, sides);
  EXPECT_EQ(sides, (std::vector<Side>{Side::Source, Side::Source, Side::Axis, Side::Axis, Side::Target, Side::Target}));
}

TEST(MarkAxis, MarksNoneWhosePartnerIsFarther)
{
  const std::vector<float> values{0.5F, 0.3F, 0.1F, -0.2F, -0.3F, -1.0F};
  std::vector<Side> sides = labelSides(values);
  markAxis(chain(6), values, {5, 4, 4, 1, 1, 0}, sides);
  EXPECT_EQ(sides, labelSides(values));
}

TEST(MarkAxis, KnowsOneSideOnly)
{
  std::vector<Side> sides = labelSides({1.0F, 2.0F});
  markAxis(chain(2), {1.0F, 2.0F}, {1, 0}, sides);
  EXPECT_EQ(sides, (std::vector<Side>{Side::Source, Side::Source}));
}
