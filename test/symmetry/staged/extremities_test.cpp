#include "geodesic/shortest_paths.h"
#include "support/graphs.h"
#include "symmetry/staged/extremities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A stick figure: arms of length \a arm from the shoulder, legs of length \a leg from the hip, a spine of length 4
 * between the two and a neck of length 2; one vertex per unit. */
struct StickFigure {
  SurfaceGraph graph;
  Index left_hand = no_index;
  Index right_hand = no_index;
  Index left_foot = no_index;
  Index right_foot = no_index;
};

StickFigure
stickFigure(int arm, int leg)
{
  std::vector<GraphEdge> edges;
  Index count = 1; // vertex 0: the shoulder
  const auto grow = [&](Index from, int length) {
    for (int i = 0; i < length; ++i) {
      edges.push_back({from, count, 1.0F});
      from = count++;
    }
    return from;
  };
  StickFigure figure;
  const Index hip = grow(0, 4);
  grow(0, 2);
  figure.left_hand = grow(0, arm);
  figure.right_hand = grow(0, arm);
  figure.left_foot = grow(hip, leg);
  figure.right_foot = grow(hip, leg);
  figure.graph = buildGraph(static_cast<std::size_t>(count), edges);
  return figure;
}

std::set<std::set<Index>>
partners(const ExtremePairs& pairs)
{
  return {{pairs.h1, pairs.h2}, {pairs.f1, pairs.f2}};
}

} // namespace

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
  const ExtremityFunctions functions = extremityFunctions(figure.graph, 0, n, 1.0F, 2); // every vertex is a sample
  std::vector<Index> everyone(n);
  for (std::size_t v = 0; v < n; ++v) {
    everyone[v] = static_cast<Index>(v);
  }
  const DistanceFields fields = distanceFields(figure.graph, everyone, 1);
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

TEST(PairExtremePoints, PairsHandsWithHandsAndFeetWithFeetOnTheirSides)
{
  const StickFigure figure = stickFigure(7, 12);
  const GeodesicMetric metric(figure.graph);
  const ExtremityFunctions functions = extremityFunctions(figure.graph, 0, 100, 1.0F, 1);
  std::array<Index, 4> points = {figure.left_hand, figure.left_foot, figure.right_hand, figure.right_foot};
  std::sort(points.begin(), points.end());
  do {
    const ExtremePairs pairs =
        pairExtremePoints(points, functions.average, metric, {0, 2, figure.left_hand, figure.left_foot}, 1);
    EXPECT_EQ(partners(pairs), (std::set<std::set<Index>>{{figure.left_hand, figure.right_hand},
                                                          {figure.left_foot, figure.right_foot}}));
  } while (std::next_permutation(points.begin(), points.end()));
}

TEST(PairExtremePoints, LooksAtTheDistributionWhereTheMeansAreNotClear)
{
  // The feature puts the points in the order hand, foot, hand, foot, the smallest step in the middle.
  const StickFigure figure = stickFigure(7, 9);
  std::vector<float> feature(figure.graph.size(), 0.0F);
  feature[figure.left_hand] = 1.00F;
  feature[figure.left_foot] = 1.02F;
  feature[figure.right_hand] = 1.03F;
  feature[figure.right_foot] = 1.05F;
  std::vector<Index> landmarks;
  for (Index v = 0; v < static_cast<Index>(figure.graph.size()); v += 2) {
    landmarks.push_back(v);
  }
  const ExtremePairs pairs =
      pairExtremePoints({figure.left_hand, figure.left_foot, figure.right_hand, figure.right_foot}, feature,
                        GeodesicMetric(figure.graph), landmarks, 1);
  EXPECT_EQ(partners(pairs),
            (std::set<std::set<Index>>{{figure.left_hand, figure.right_hand}, {figure.left_foot, figure.right_foot}}));
}

TEST(PairExtremePoints, LooksAtTheDistributionWhereTheMeansDifferByAPoseOnly)
{
  // A step in the middle, but of 1 %: arms as long as legs.
  const StickFigure figure = stickFigure(7, 9);
  std::vector<float> feature(figure.graph.size(), 0.0F);
  feature[figure.left_hand] = 1.000F;
  feature[figure.left_foot] = 1.002F;
  feature[figure.right_hand] = 1.012F;
  feature[figure.right_foot] = 1.015F;
  const ExtremePairs pairs =
      pairExtremePoints({figure.left_hand, figure.left_foot, figure.right_hand, figure.right_foot}, feature,
                        GeodesicMetric(figure.graph), {0, 2, 5, 12, 15}, 1);
  EXPECT_EQ(partners(pairs),
            (std::set<std::set<Index>>{{figure.left_hand, figure.right_hand}, {figure.left_foot, figure.right_foot}}));
}

TEST(PairExtremePoints, PutsTheNearerOnesOnOneSide)
{
  // A rectangle with corners 0, 1 (left) and 2, 3 (right); the feature makes partners of the upper and of the lower.
  const SurfaceGraph rectangle = buildGraph(4, {{0, 1, 1.0F}, {1, 3, 3.0F}, {3, 2, 1.0F}, {2, 0, 3.0F}});
  const GeodesicMetric metric(rectangle);
  const ExtremePairs pairs = pairExtremePoints({0, 1, 2, 3}, {1.0F, 9.0F, 1.0F, 9.0F}, metric, {0, 1, 2, 3}, 1);
  EXPECT_EQ(pairs.h1, 0);
  EXPECT_EQ(pairs.h2, 2);
  EXPECT_EQ(pairs.f1, 1);
  EXPECT_EQ(pairs.f2, 3);
}

TEST(PairingFeature, DependsOnTheSizeOnlyWhereThatIsAskedFor)
{
  ExtremityFunctions functions;
  functions.average.assign(100, 1.0F);
  functions.minimal.assign(100, 2.0F);
  EXPECT_EQ(pairingFeature(functions, PairingFeature::AverageGeodesicDistance), functions.average);
  EXPECT_EQ(pairingFeature(functions, PairingFeature::MinimalGeodesicDistance), functions.minimal);
  EXPECT_EQ(pairingFeature(functions, PairingFeature::BySurfaceSize), functions.average);
  functions.average.assign(30000, 1.0F);
  functions.minimal.assign(30000, 2.0F);
  EXPECT_EQ(pairingFeature(functions, PairingFeature::AverageGeodesicDistance), functions.average);
  EXPECT_EQ(pairingFeature(functions, PairingFeature::BySurfaceSize), functions.minimal);
}
