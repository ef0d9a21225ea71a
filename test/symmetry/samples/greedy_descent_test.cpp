#include "support/graphs.h"
#include "symmetry/samples/greedy_descent.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A closed ring of \a n vertices. */
SurfaceGraph
ring(Index n)
{
  std::vector<GraphEdge> edges;
  for (Index v = 0; v < n; ++v) {
    edges.push_back({v, (v + 1) % n, 1.0F});
  }
  return buildGraph(static_cast<std::size_t>(n), edges);
}

TEST(WalkDown, EndsAtTheLeastCostAround)
{
  const SurfaceGraph graph = ring(40);
  const auto one_valley = [](Index v) {
    return std::abs(static_cast<float>(v) - 17.0F);
  };
  for (Index start = 0; start < 40; ++start) {
    EXPECT_EQ(walkDown(graph, start, one_valley), 17);
  }
  const auto two_valleys = [](Index v) {
    return std::abs(static_cast<float>(v % 20) - 10.0F);
  };
  EXPECT_EQ(walkDown(graph, 5, two_valleys), 10);
  EXPECT_EQ(walkDown(graph, 33, two_valleys), 30);
}

TEST(WalkDown, StaysWhereNothingIsGained)
{
  EXPECT_EQ(walkDown(ring(10), 4, [](Index) { return 1.0F; }), 4);
  EXPECT_EQ(walkDown(buildGraph(3, {}), 2, [](Index v) { return static_cast<float>(v); }), 2);
}

} // namespace
