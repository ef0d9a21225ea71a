#include "support/graphs.h"
#include "symmetry/sides/curve_thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Lines on a grid where a function is zero half way between two rows, those before each of some. */
std::vector<ZeroLine>
linesAlong(int columns, int rows, const std::vector<int>& rows_after)
{
  const Surface grid = gridMesh(columns, rows);
  std::vector<float> values;
  for (int row = 0; row < rows; ++row) {
    const auto passed = std::count_if(rows_after.begin(), rows_after.end(), [&](int after) { return row >= after; });
    values.insert(values.end(), static_cast<std::size_t>(columns), passed % 2 == 0 ? 1.0F : -1.0F);
  }
  return cloudContours(meshGraph(grid), grid.points, values);
}

TEST(CurveThinning, RunsFromEndToEnd)
{
  const int columns = 40;
  const std::vector<ZeroLine> lines = linesAlong(columns, 9, {4});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  std::set<int> met;
  for (const ZeroCrossing& crossing : lines[0].crossings) {
    met.insert(crossing.from % columns);
    EXPECT_EQ(std::minmax(crossing.from / columns, crossing.to / columns), std::minmax(3, 4));
    EXPECT_EQ(crossing.share, 0.5F);
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(columns));
}

TEST(CurveThinning, GivesEveryBandItsLine)
{
  const std::vector<ZeroLine> lines = linesAlong(40, 20, {3, 14});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].crossings.front().from / 40 < 9, lines[1].crossings.front().from / 40 < 9);
}

TEST(CurveThinning, ClosesARing)
{
  // A flat ring: a tube would be closed the other way, too.
  constexpr int around = 60;
  std::vector<GraphEdge> edges;
  std::vector<float> values;
  std::vector<Vector3> points;
  for (Index i = 0; i < around; ++i) {
    const Index next = (i + 1) % around;
    const float angle = 6.2831853F * static_cast<float>(i) / around;
    for (Index row = 0; row < 2; ++row) {
      const float radius = 10.0F + static_cast<float>(row);
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0F});
      values.push_back(row == 0 ? 1.0F : -1.0F);
      edges.push_back({i * 2 + row, next * 2 + row, 1.0F});
    }
    edges.push_back({i * 2, i * 2 + 1, 1.0F});
    edges.push_back({i * 2, next * 2 + 1, 1.0F});
  }
  const std::vector<ZeroLine> lines = cloudContours(buildGraph(values.size(), edges), points, values);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].closed);
  std::set<Index> met;
  for (const ZeroCrossing& crossing : lines[0].crossings) {
    met.insert(crossing.from / 2);
  }
  EXPECT_GE(met.size(), around * 9U / 10U);
}

TEST(CurveThinning, HasNothingToThinWithoutABand)
{
  EXPECT_TRUE(linesAlong(10, 10, {}).empty());
}

} // namespace
