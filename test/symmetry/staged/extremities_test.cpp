#include "geodesic/shortest_paths.h"
#include "stick_figure.h"
#include "support/graphs.h"
#include "support/with_threads.h"
#include "symmetry/staged/extremities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

TEST(EmbeddedGraph, HasTheEdgesOfTheSurfaceAndTheLengthsOfTheEmbedding)
{
  const SurfaceGraph graph = meshGraph(gridMesh(3, 2));
  SpectralEmbedding embedding;
  embedding.dimensions = 2;
  for (int v = 0; v < 6; ++v) {
    embedding.coordinates.push_back(3.0F * static_cast<float>(v % 3));
    embedding.coordinates.push_back(4.0F * static_cast<float>(v / 3));
  }
  const SurfaceGraph embedded = embeddedGraph(graph, embedding);
  EXPECT_EQ(embedded.neighbours, graph.neighbours);
  EXPECT_FLOAT_EQ(edgeLength(embedded, 0, 1), 3.0F);
  EXPECT_FLOAT_EQ(edgeLength(embedded, 0, 3), 4.0F);
  EXPECT_FLOAT_EQ(edgeLength(embedded, 0, 4), 5.0F);
}

TEST(MutuallyFarthestVertices, AreTheExtremitiesOfTheLimbs)
{
  const StickFigure figure = stickFigure(7, 9);
  for (const Index start : {0, 3, 12}) {
    std::vector<Index> extremities = mutuallyFarthestVertices(figure.graph, start, 4);
    std::sort(extremities.begin(), extremities.end());
    EXPECT_EQ(extremities,
              (std::vector<Index>{figure.left_hand, figure.right_hand, figure.left_foot, figure.right_foot}));
  }
}

TEST(MutuallyFarthestVertices, CannotBeImprovedByMovingOne)
{
  const SurfaceGraph graph = meshGraph(scaled(sphereMesh(4), {1.0F, 2.0F, 0.5F}));
  const std::vector<Index> points = mutuallyFarthestVertices(graph, 0, 4);
  ASSERT_EQ(points.size(), 4U);
  for (const Index point : points) {
    std::vector<Index> others;
    std::copy_if(points.begin(), points.end(), std::back_inserter(others), [&](Index v) { return v != point; });
    const std::vector<float> field = distanceField(graph, others);
    EXPECT_EQ(field[point], *std::max_element(field.begin(), field.end()));
  }
}

TEST(MutuallyFarthestVertices, AreFewerWhereThereAreNoMore)
{
  EXPECT_EQ(mutuallyFarthestVertices(buildGraph(3, {{0, 1, 0.0F}, {1, 2, 1.0F}}), 0, 4).size(), 2U);
}

TEST(ExtremityFunctions, AreTheMeanDistanceAndTheDistanceToItsMaxima)
{
  const StickFigure figure = stickFigure(7, 9);
  const std::size_t n = figure.graph.size();
  const ExtremityFunctions functions =
      withThreads(2, [&] { return extremityFunctions(figure.graph, 0, n, 1.0F); }); // every vertex is a sample
  std::vector<Index> everyone(n);
  for (std::size_t v = 0; v < n; ++v) {
    everyone[v] = static_cast<Index>(v);
  }
  const DistanceFields fields = distanceFields(figure.graph, everyone);
  const auto mean = [&](Index v) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < n; ++i) {
      sum += fields.row(i)[v];
    }
    return sum / static_cast<float>(n);
  };
  // A fingertip has one neighbour: smoothed, its value is the mean of both.
  EXPECT_NEAR(functions.average[figure.left_hand], 0.5F * (mean(figure.left_hand) + mean(figure.left_hand - 1)), 1e-4F);

  const std::set<Index> extremities(functions.average_maxima.begin(), functions.average_maxima.end());
  EXPECT_EQ(extremities.size(), 5U); // with the head
  for (const Index extremity : {figure.left_hand, figure.right_hand, figure.left_foot, figure.right_foot}) {
    EXPECT_EQ(extremities.count(extremity), 1U);
  }
  EXPECT_EQ(functions.minimal, distanceField(figure.graph, functions.average_maxima));
  for (const Index v : functions.minimal_maxima) {
    EXPECT_EQ(extremities.count(v), 0U);
  }
}
