#include "geodesic/nested_dissection.h"
#include "support/graphs.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(Dissection, HasEveryVertexOnceAndNoEdgeAcross)
{
  for (const SurfaceGraph& graph : {meshGraph(sphereMesh(4)), meshGraph(gridMesh(70, 3)), meshGraph(gridMesh(1, 1)),
                                    randomGraph(500, 3, evenLength), buildGraph(100, {}), buildGraph(0, {})}) {
    const Dissection dissection = dissect(graph, 10);
    std::vector<Index> sorted = dissection.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Index> all(graph.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);

    std::vector<std::int32_t> node_of(graph.size());
    std::uint32_t next = 0;
    for (std::size_t node = 0; node < dissection.nodes.size(); ++node) {
      const Dissection::Node& owner = dissection.nodes[node];
      EXPECT_EQ(owner.begin, next);
      next = owner.end;
      EXPECT_TRUE(owner.children[0] >= 0 || owner.end - owner.begin <= 10U);
      for (std::uint32_t p = owner.begin; p < owner.end; ++p) {
        node_of[dissection.order[p]] = static_cast<std::int32_t>(node);
      }
    }
    const auto is_ancestor = [&](std::int32_t above, std::int32_t node) {
      while (node >= 0 && node != above) {
        node = dissection.nodes[node].parent;
      }
      return node == above;
    };
    for (std::size_t v = 0; v < graph.size(); ++v) {
      for (const Index w : graph.neighboursOf(v)) {
        const std::int32_t other = node_of[w];
        EXPECT_TRUE(is_ancestor(other, node_of[v]) || is_ancestor(node_of[v], other));
      }
    }
  }
}

TEST(Dissection, OfASurfaceHasSmallSeparators)
{
  const SurfaceGraph graph = meshGraph(gridMesh(100, 100));
  const Dissection dissection = dissect(graph, 32);
  const Dissection::Node& root = dissection.nodes.back();
  EXPECT_LE(root.end - root.begin, 150U);
  EXPECT_GE(root.end - root.begin, 50U);
}

TEST(Dissection, CutsWhereTheSurfaceIsNarrow)
{
  // Two squares of different size, joined by a strip of four vertices: the middle lies in the larger one.
  std::vector<GraphEdge> edges;
  const auto add_grid = [&edges](Index first, Index width, Index height) {
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        const Index v = first + y * width + x;
        if (x + 1 < width) {
          edges.push_back({v, v + 1, 1.0F});
        }
        if (y + 1 < height) {
          edges.push_back({v, v + width, 1.0F});
        }
      }
    }
  };
  add_grid(0, 40, 40);
  add_grid(1600, 34, 34);
  for (Index y = 0; y < 4; ++y) {
    edges.push_back({y * 40, 1600 + y * 34, 1.0F});
  }
  const Dissection dissection = dissect(buildGraph(1600 + 34 * 34, edges), 32);
  const Dissection::Node& root = dissection.nodes.back();
  EXPECT_LE(root.end - root.begin, 4U);
}

TEST(Dissection, IsTheSameForAnyNumberOfThreads)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(5));
  const std::vector<Index> order = dissect(graph, 32).order;
  for (const unsigned threads : {2U, 3U, 8U}) {
    EXPECT_EQ(withThreads(threads, [&] { return dissect(graph, 32); }).order, order);
  }
}

} // namespace
