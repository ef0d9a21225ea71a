#include "geodesic/marked_groups.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

/** A chain of vertices. */
SurfaceGraph
chain(Index size)
{
  SurfaceGraph graph;
  for (Index v = 0; v < size; ++v) {
    for (const Index w : {v - 1, v + 1}) {
      if (w >= 0 && w < size) {
        graph.neighbours.push_back(w);
        graph.lengths.push_back(1.0F);
      }
    }
    graph.offsets.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
  }
  return graph;
}

TEST(MarkedGroups, AreConnectedThroughMarkedPointsOnly)
{
  UnionFind groups = markedGroups(chain(7), {1, 1, 0, 1, 1, 1, 0});
  EXPECT_EQ(groups.find(1), 0);
  EXPECT_EQ(groups.find(4), 3);
  EXPECT_EQ(groups.find(5), 3);
  EXPECT_EQ(groups.find(2), 2) << "without a mark";
  EXPECT_EQ(groups.find(6), 6) << "beside a group, without a mark";
}

} // namespace
