#include "geodesic/shortest_paths.h"
#include "geodesic/vertex_functions.h"
#include "support/graphs.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

SurfaceGraph
chain(std::size_t n)
{
  std::vector<GraphEdge> edges;
  for (std::size_t v = 1; v < n; ++v) {
    edges.push_back({static_cast<Index>(v - 1), static_cast<Index>(v), 1.0F});
  }
  return buildGraph(n, edges);
}

} // namespace

TEST(SmoothOverRings, IsTheMeanOfAVertexAndItsNeighbours)
{
  EXPECT_EQ(smoothOverRings(chain(4), {0.0F, 3.0F, 6.0F, 0.0F}, 1), (std::vector<float>{1.5F, 3.0F, 3.0F, 3.0F}));
  EXPECT_EQ(smoothOverRings(chain(4), {0.0F, 3.0F, 6.0F, 0.0F}, 2), (std::vector<float>{2.25F, 2.5F, 3.0F, 3.0F}));
  EXPECT_EQ(smoothOverRings(chain(3), {1.0F, 2.0F, 4.0F}, 0), (std::vector<float>{1.0F, 2.0F, 4.0F}));
}

TEST(SmoothOverRings, KeepsAConstant)
{
  const SurfaceGraph sphere = meshGraph(sphereMesh(3));
  const std::vector<float> constant(sphere.size(), 2.0F);
  EXPECT_EQ(smoothOverRings(sphere, constant, 5), constant);
}

TEST(LocalMaxima, AreLargerThanAllNeighbours)
{
  EXPECT_EQ(localMaxima(chain(6), {3.0F, 1.0F, 2.0F, 5.0F, 4.0F, 4.5F}), (std::vector<Index>{0, 3, 5}));
}

TEST(LocalMaxima, OfAPlateauAreItsLowestVertex)
{
  EXPECT_EQ(localMaxima(chain(6), {1.0F, 2.0F, 2.0F, 2.0F, 1.0F, 0.0F}), std::vector<Index>{1});
  EXPECT_EQ(localMaxima(chain(3), {7.0F, 7.0F, 7.0F}), std::vector<Index>{0});
}

TEST(LocalMaxima, AreNoneWhereAVertexHasNoNeighbours)
{
  EXPECT_TRUE(localMaxima(buildGraph(3, {}), {1.0F, 2.0F, 3.0F}).empty());
}

TEST(Separated, KeepsTheLargestOfVerticesThatAreClose)
{
  const SurfaceGraph graph = chain(10);
  const std::vector<float> values = {5.0F, 0.0F, 6.0F, 0.0F, 0.0F, 5.5F, 0.0F, 0.0F, 0.0F, 5.5F};
  EXPECT_EQ(separated(graph, {0, 2, 5, 9}, values, 3.0F), (std::vector<Index>{2, 5, 9}));
  EXPECT_EQ(separated(graph, {0, 2, 5, 9}, values, 4.5F), (std::vector<Index>{2, 9}));
  EXPECT_EQ(separated(graph, {9, 5, 2, 0}, values, 0.0F), (std::vector<Index>{2, 5, 9, 0}));
  EXPECT_TRUE(separated(graph, {}, values, 1.0F).empty());
}

TEST(Separated, LeavesNoTwoCloserAndNoneThatWouldFit)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(3));
  std::vector<Index> all(graph.size());
  std::vector<float> values(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    all[v] = static_cast<Index>(v);
    values[v] = static_cast<float>((v * 7919U) % 1009U);
  }
  const std::vector<Index> kept = separated(graph, all, values, 0.5F);
  const DistanceFields fields = withThreads(2, [&] { return distanceFields(graph, kept); });
  for (std::size_t v = 0; v < graph.size(); ++v) {
    std::size_t close = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      close += fields.row(i)[v] < 0.5F ? 1 : 0;
    }
    EXPECT_GE(close, 1U);
    if (std::find(kept.begin(), kept.end(), v) != kept.end()) {
      EXPECT_EQ(close, 1U); // itself
    }
  }
}
