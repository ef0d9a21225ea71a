#include "support/graphs.h"
#include "symmetry/sides/curve_thinning.h"

#include <gtest/gtest.h>

#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A strip three vertices wide along each of some rows of a grid; the function is zero in the middle of the strips. */
std::vector<Polyline>
curvesAlong(int columns, int rows, const std::vector<int>& middles)
{
  std::vector<float> values(static_cast<std::size_t>(columns * rows), 9.0F);
  std::vector<Side> sides(values.size(), Side::Source);
  for (const int middle : middles) {
    for (int row = middle - 1; row <= middle + 1; ++row) {
      for (int column = 0; column < columns; ++column) {
        const auto v = static_cast<std::size_t>(row * columns + column);
        values[v] = static_cast<float>(row - middle);
        sides[v] = Side::Axis;
      }
    }
  }
  return bandCurves(meshGraph(gridMesh(columns, rows)), values, sides);
}

TEST(CurveThinning, KeepsToTheMiddleOfABand)
{
  const int columns = 40;
  const std::vector<Polyline> curves = curvesAlong(columns, 9, {4});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  std::set<int> met;
  for (const Index v : curves[0].points) {
    met.insert(v % columns);
    if (v % columns > 2 && v % columns < columns - 3) {
      EXPECT_EQ(v / columns, 4) << v; // towards the ends it may come from a corner
    }
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(columns)); // from end to end
}

TEST(CurveThinning, GivesEveryBandItsCurve)
{
  const std::vector<Polyline> curves = curvesAlong(40, 20, {3, 14});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_NE(curves[0].points.front() / 40 < 9, curves[1].points.front() / 40 < 9);
}

TEST(CurveThinning, ClosesARing)
{
  // A tube of three vertices across would be closed the other way, too: a flat ring is not.
  constexpr int around = 60;
  std::vector<GraphEdge> edges;
  std::vector<float> values;
  for (Index i = 0; i < around; ++i) {
    const Index next = (i + 1) % around;
    for (Index row = 0; row < 3; ++row) {
      values.push_back(static_cast<float>(row - 1));
      edges.push_back({i * 3 + row, next * 3 + row, 1.0F});
      if (row < 2) {
        edges.push_back({i * 3 + row, i * 3 + row + 1, 1.0F});
      }
    }
  }
  const SurfaceGraph graph = buildGraph(values.size(), edges);
  const std::vector<Polyline> curves = bandCurves(graph, values, std::vector<Side>(values.size(), Side::Axis));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  std::set<Index> met;
  for (const Index v : curves[0].points) {
    met.insert(v / 3);
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(around));
}

TEST(CurveThinning, HasNothingToThinWithoutABand)
{
  EXPECT_TRUE(curvesAlong(10, 10, {}).empty());
}

} // namespace
