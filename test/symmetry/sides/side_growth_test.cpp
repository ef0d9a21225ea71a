#include "support/graphs.h"
#include "symmetry/sides/side_growth.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A grid mirrored about its middle column. */
struct MirroredGrid {
  static constexpr int width = 21;
  static constexpr int height = 30;
  SurfaceGraph graph = meshGraph(gridMesh(width, height));
  std::vector<Index> partners;
  std::vector<float> ways;
  std::vector<float> side_function;

  MirroredGrid()
  {
    for (Index v = 0; v < width * height; ++v) {
      partners.push_back(v - v % width + (width - 1 - v % width));
      ways.push_back(2.0F * std::abs(column(v)));
      side_function.push_back(column(v) > 0.0F ? 1.0F : column(v) < 0.0F ? -1.0F : 0.0F);
    }
  }

  /** Signed, from the middle. */
  static float
  column(Index v)
  {
    return static_cast<float>(v % width - width / 2);
  }

  std::vector<float>
  grown() const
  {
    return growSides(graph, partners, ways, side_function);
  }

  void
  expectRight(const std::vector<float>& sides) const
  {
    for (Index v = 0; v < width * height; ++v) {
      if (column(v) != 0.0F) {
        EXPECT_EQ(sides[v], 2.0F * column(v)) << v;
      }
      else {
        EXPECT_NE(sides[v], 0.0F) << v;
      }
    }
  }
};

TEST(GrowSides, SignsTheWaysWhereTheFunctionIsClear)
{
  const MirroredGrid grid;
  grid.expectRight(grid.grown());
}

TEST(GrowSides, ReachesWhatTheFunctionLeavesOpenOrGetsFaintlyWrong)
{
  MirroredGrid grid;
  for (std::size_t v = 100; v < grid.side_function.size(); ++v) {
    grid.side_function[v] = v % 3 == 0 ? 0.0F : v % 3 == 1 ? 0.3F : -0.3F;
  }
  grid.expectRight(grid.grown());
}

TEST(GrowSides, GivesThePartnerTheOtherSide)
{
  MirroredGrid grid;
  for (std::size_t v = 0; v < grid.side_function.size(); ++v) { // known on one side alone
    grid.side_function[v] = std::max(0.0F, v > 40 ? 0.0F : grid.side_function[v]);
  }
  const std::vector<float> sides = grid.grown();
  for (std::size_t v = 0; v < sides.size(); ++v) {
    if (grid.ways[v] > 0.0F) {
      EXPECT_LT(sides[v] * sides[grid.partners[v]], 0.0F) << v;
    }
  }
}

TEST(GrowSides, BetweenEqualsTheFunctionDecides)
{
  // 0 - 1 and 2 - 3 are partners; 1 and 2 can be reached from 0 alone, equally soon.
  const SurfaceGraph graph = buildGraph(4, {{0, 1, 1.0F}, {0, 2, 1.0F}, {0, 3, 1.0F}});
  const std::vector<Index> partners{1, 0, 3, 2};
  const std::vector<float> ways{4.0F, 4.0F, 1.0F, 1.0F};
  EXPECT_EQ(growSides(graph, partners, ways, {1.0F, -1.0F, 0.1F, -0.1F}),
            (std::vector<float>{4.0F, -4.0F, 1.0F, -1.0F}));
  EXPECT_EQ(growSides(graph, partners, ways, {1.0F, -1.0F, -0.1F, 0.1F}),
            (std::vector<float>{4.0F, -4.0F, -1.0F, 1.0F}));
}

TEST(GrowSides, CrossesNoAxisThatTheFunctionKnowsWhereTheMapIsWrong)
{
  MirroredGrid grid;
  for (Index v = 0; v < MirroredGrid::width * MirroredGrid::height; ++v) {
    const float column = MirroredGrid::column(v);
    if (std::abs(column) < 8.0F) {
      grid.side_function[v] = 0.04F * column;
    }
    if (std::abs(column) < 4.0F && v / MirroredGrid::width == 14) { // a bridge of long ways across the axis
      grid.partners[v] = v;
      grid.ways[v] = 30.0F;
    }
  }
  const std::vector<float> sides = grid.grown();
  for (Index v = 0; v < MirroredGrid::width * MirroredGrid::height; ++v) {
    EXPECT_GE(sides[v] * MirroredGrid::column(v), 0.0F) << v;
  }
}

TEST(GrowSides, LeavesWhatNoSideReaches)
{
  const SurfaceGraph graph = buildGraph(4, {{0, 1, 1.0F}, {2, 3, 1.0F}});
  const std::vector<Index> partners{1, 0, 3, 2};
  const std::vector<float> ways(4, 1.0F);
  EXPECT_EQ(growSides(graph, partners, ways, {1.0F, -1.0F, 0.0F, 0.0F}), (std::vector<float>{1.0F, -1.0F, 0.0F, 0.0F}));
  EXPECT_EQ(growSides(graph, partners, ways, std::vector<float>(4, 0.0F)), std::vector<float>(4, 0.0F));
  EXPECT_TRUE(growSides(buildGraph(0, {}), {}, {}, {}).empty());
}

} // namespace
