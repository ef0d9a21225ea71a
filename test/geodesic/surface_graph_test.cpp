#include "geodesic/neighbour_graph.h"
#include "geodesic/surface_graph.h"
#include "support/graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

TEST(BuildGraph, HoldsEveryEdgeInBothDirectionsAscending)
{
  const SurfaceGraph graph = buildGraph(4, {{2, 0, 3.0F}, {0, 1, 1.0F}, {3, 0, 2.0F}});
  EXPECT_EQ(graph.offsets, (std::vector<std::uint32_t>{0, 3, 4, 5, 6}));
  EXPECT_EQ(graph.neighbours, (std::vector<Index>{1, 2, 3, 0, 0, 0}));
  EXPECT_EQ(graph.lengths, (std::vector<float>{1.0F, 3.0F, 2.0F, 1.0F, 3.0F, 2.0F}));
}

TEST(BuildGraph, DropsSelfLoopsAndKeepsTheShortestOfParallelEdges)
{
  const SurfaceGraph graph = buildGraph(3, {{0, 0, 0.5F}, {0, 1, 4.0F}, {1, 0, 2.0F}, {0, 1, 3.0F}});
  EXPECT_EQ(graph.neighbours, (std::vector<Index>{1, 0}));
  EXPECT_EQ(graph.lengths, (std::vector<float>{2.0F, 2.0F}));
  EXPECT_EQ(graph.size(), 3U);
  EXPECT_EQ(buildGraph(0, {}).size(), 0U);
}

TEST(BuildMeshGraph, HasTheEdgesOfTheMesh)
{
  const Surface sphere = sphereMesh(3);
  const SurfaceGraph graph = meshGraph(sphere);
  EXPECT_EQ(graph.neighbours.size() / 2, sphere.size() + sphere.triangles.size() - 2); // Euler
  for (std::size_t v = 0; v < graph.size(); ++v) {
    EXPECT_TRUE(
        std::is_sorted(graph.neighbours.begin() + graph.offsets[v], graph.neighbours.begin() + graph.offsets[v + 1]));
  }
}

TEST(EdgeLength, IsInfiniteWhereThereIsNoEdge)
{
  const SurfaceGraph grid = meshGraph(gridMesh(3, 3));
  EXPECT_FLOAT_EQ(edgeLength(grid, 0, 1), 1.0F);
  EXPECT_FLOAT_EQ(edgeLength(grid, 4, 0), std::sqrt(2.0F));
  EXPECT_EQ(edgeLength(grid, 0, 8), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(areNeighbours(grid, 0, 4));
  EXPECT_FALSE(areNeighbours(grid, 2, 4)); // the diagonals run the other way
  EXPECT_FALSE(areNeighbours(grid, 0, 0));
}

TEST(SurfaceGraph, GivesTheEdgesOfAVertex)
{
  const SurfaceGraph graph = buildGraph(4, {{1, 0, 0.5F}, {1, 3, 2.5F}});
  std::vector<Index> neighbours;
  std::vector<float> lengths;
  for (const auto [neighbour, length] : graph.edges(1)) {
    neighbours.push_back(neighbour);
    lengths.push_back(length);
  }
  EXPECT_EQ(neighbours, (std::vector<Index>{0, 3}));
  EXPECT_EQ(lengths, (std::vector<float>{0.5F, 2.5F}));
  EXPECT_EQ(std::vector<Index>(graph.neighboursOf(3).begin(), graph.neighboursOf(3).end()), (std::vector<Index>{1}));
  EXPECT_EQ(graph.degree(1), 2U);
  EXPECT_TRUE(graph.neighboursOf(2).empty());
  EXPECT_FALSE(graph.edges(2).begin() != graph.edges(2).end());
}

TEST(NeighbourLists, EndWhereFewerWereFound)
{
  const NeighbourLists lists{2, {0, 1, 2, no_index, no_index, no_index}};
  EXPECT_EQ(lists.of(0).size(), 2U);
  EXPECT_EQ(lists.of(0)[1], 1);
  EXPECT_EQ(std::vector<Index>(lists.of(1).begin(), lists.of(1).end()), (std::vector<Index>{2}));
  EXPECT_TRUE(lists.of(2).empty());
}

TEST(ConnectedComponents, AreOrderedBySizeThenByLowestVertex)
{
  const Components components =
      connectedComponents(buildGraph(8, {{1, 2, 1.0F}, {3, 4, 1.0F}, {4, 5, 1.0F}, {6, 7, 0.0F}}));
  EXPECT_EQ(components.sizes, (std::vector<Index>{3, 2, 2, 1}));
  EXPECT_EQ(components.component_of, (std::vector<Index>{3, 1, 1, 0, 0, 0, 2, 2}));
}

TEST(NeighbourGraph, IsSymmetricWhereTheSearchIsNot)
{
  // Point 2 is far out: it has the others as its nearest, but is nobody's.
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  const NeighbourLists lists{2, {0, 1, 1, 0, 2, 1}};
  const SurfaceGraph graph = buildNeighbourGraph(points, lists, 0.0F);
  EXPECT_EQ(graph.neighbours, (std::vector<Index>{1, 0, 2, 1}));
  EXPECT_EQ(graph.lengths, (std::vector<float>{1.0F, 1.0F, 4.0F, 4.0F}));
}

TEST(NeighbourGraph, HonoursTheRadiusAndMissingNeighbours)
{
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  const NeighbourLists lists{2, {1, 2, 0, no_index, 1, no_index}};
  EXPECT_EQ(buildNeighbourGraph(points, lists, 2.0F).neighbours, (std::vector<Index>{1, 0}));
}

TEST(NeighbourGraph, JoinsDuplicatesByEdgesOfLengthZero)
{
  const std::vector<Vector3> points = {{1, 2, 3}, {1, 2, 3}};
  const SurfaceGraph graph = buildNeighbourGraph(points, {2, {1, 0, 0, 1}}, 0.0F);
  EXPECT_EQ(graph.neighbours, (std::vector<Index>{1, 0}));
  EXPECT_EQ(graph.lengths, (std::vector<float>{0.0F, 0.0F}));
}
