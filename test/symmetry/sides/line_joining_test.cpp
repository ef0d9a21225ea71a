#include "support/prepared.h"
#include "symmetry/sides/line_joining.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A grid of unit size. */
Surface
unitGrid(int columns, int rows)
{
  Surface grid = gridMesh(columns, rows);
  for (Vector3& p : grid.points) {
    for (float& x : p) {
      x /= static_cast<float>(columns - 1);
    }
  }
  return grid;
}

/** Stretches of a line along the columns of a grid, half way between two rows. */
ZeroLine
stretch(int columns, int row, int first, int last)
{
  ZeroLine line;
  for (int column = first; column <= last; ++column) {
    line.crossings.push_back({row * columns + column, (row + 1) * columns + column, 0.5F});
  }
  return line;
}

std::vector<float>
heights(const Surface& grid, float zero)
{
  std::vector<float> values;
  for (const Vector3& p : grid.points) {
    values.push_back(2.0F * (p[1] - zero));
  }
  return values;
}

TEST(JoinedLines, BridgesAGapAlongTheZero)
{
  const Surface grid = unitGrid(41, 21);
  const PreparedSurface surface = prepared(grid);
  const std::vector<ZeroLine> lines =
      joinedLines(surface, heights(grid, 10.5F / 40.0F), {stretch(41, 10, 0, 18), stretch(41, 10, 22, 40)});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_NEAR(lengthOf(lines[0], surface.points), 1.0F, 0.06F);
}

TEST(JoinedLines, LeavesWideGapsAndEndsOfTheSurface)
{
  const Surface grid = unitGrid(41, 21);
  const PreparedSurface surface = prepared(grid);
  const std::vector<float> values = heights(grid, 10.5F / 40.0F);
  EXPECT_EQ(joinedLines(surface, values, {stretch(41, 10, 0, 12), stretch(41, 10, 24, 40)}).size(), 2U);
  const std::vector<ZeroLine> whole = joinedLines(surface, values, {stretch(41, 10, 0, 40)});
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_FALSE(whole[0].closed);
}

TEST(JoinedLines, LeavesEndsThatTheSurfaceDoesNotJoin)
{
  const Surface grid = unitGrid(41, 21);
  PreparedSurface surface = prepared(grid);
  std::vector<GraphEdge> edges; // cut in the middle
  for (std::size_t v = 0; v < grid.size(); ++v) {
    for (const auto [w, length] : surface.graph.edges(v)) {
      if ((static_cast<int>(v) % 41 < 20) == (w % 41 < 20)) {
        edges.push_back({static_cast<Index>(v), w, length});
      }
    }
  }
  surface.graph = buildGraph(grid.size(), edges);
  const std::vector<ZeroLine> two{stretch(41, 10, 0, 18), stretch(41, 10, 22, 40)};
  EXPECT_EQ(joinedLines(surface, heights(grid, 10.5F / 40.0F), two).size(), 2U);
}

} // namespace
