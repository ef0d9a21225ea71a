#include "stick_figure.h"
#include "symmetry/staged/extreme_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::set<std::set<Index>>
partners(const ExtremePairs& pairs)
{
  return {{pairs.h1, pairs.h2}, {pairs.f1, pairs.f2}};
}

std::vector<Index>
everyThird(const SurfaceGraph& graph)
{
  std::vector<Index> landmarks;
  for (Index v = 0; v < static_cast<Index>(graph.size()); v += 3) {
    landmarks.push_back(v);
  }
  return landmarks;
}

} // namespace

TEST(PairExtremePoints, PairsHandsWithHandsAndFeetWithFeetOnTheirSides)
{
  const StickFigure figure = stickFigure(7, 12);
  const GeodesicMetric metric(figure.graph);
  const ExtremityFunctions functions = extremityFunctions(figure.graph, 0, 100, 1.0F);
  std::array<Index, 4> points = {figure.left_hand, figure.left_foot, figure.right_hand, figure.right_foot};
  std::sort(points.begin(), points.end());
  do {
    const ExtremePairs pairs =
        pairExtremePoints(points, functions.average, metric, {0, 2, figure.left_hand, figure.left_foot});
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
                        GeodesicMetric(figure.graph), landmarks);
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
                        GeodesicMetric(figure.graph), {0, 2, 5, 12, 15});
  EXPECT_EQ(partners(pairs),
            (std::set<std::set<Index>>{{figure.left_hand, figure.right_hand}, {figure.left_foot, figure.right_foot}}));
}

TEST(PairExtremePoints, PutsTheNearerOnesOnOneSide)
{
  // A rectangle with corners 0, 1 (left) and 2, 3 (right); the feature makes partners of the upper and of the lower.
  const SurfaceGraph rectangle = buildGraph(4, {{0, 1, 1.0F}, {1, 3, 3.0F}, {3, 2, 1.0F}, {2, 0, 3.0F}});
  const GeodesicMetric metric(rectangle);
  const ExtremePairs pairs = pairExtremePoints({0, 1, 2, 3}, {1.0F, 9.0F, 1.0F, 9.0F}, metric, {0, 1, 2, 3});
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

TEST(ChooseExtremePairs, AreThePawsOfAnAnimalWhoseFirstFourPointsAreNot)
{
  const StickAnimal animal = stickAnimal(7, 8);
  const std::vector<Index> four = mutuallyFarthestVertices(animal.graph, 0, 4);
  EXPECT_EQ(std::count(four.begin(), four.end(), animal.tail), 1);
  const std::vector<Index> points = mutuallyFarthestVertices(animal.graph, 0, 9);
  const ExtremePairs pairs = chooseExtremePairs(points, std::vector<float>(animal.graph.size()),
                                                GeodesicMetric(animal.graph), everyThird(animal.graph));
  EXPECT_EQ(partners(pairs),
            (std::set<std::set<Index>>{{animal.left_fore, animal.right_fore}, {animal.left_hind, animal.right_hind}}));
}

TEST(ChooseExtremePairs, AreHandsAndFeetOfAFigureInAnyOrder)
{
  const StickFigure figure = stickFigure(7, 9);
  const Index head = 6;
  std::vector<Index> points = {figure.left_hand, head, figure.left_foot, figure.right_foot, figure.right_hand};
  std::sort(points.begin(), points.end());
  do {
    const ExtremePairs pairs = chooseExtremePairs(points, std::vector<float>(figure.graph.size()),
                                                  GeodesicMetric(figure.graph), everyThird(figure.graph));
    EXPECT_EQ(partners(pairs), (std::set<std::set<Index>>{{figure.left_hand, figure.right_hand},
                                                          {figure.left_foot, figure.right_foot}}));
  } while (std::next_permutation(points.begin(), points.end()));
}

TEST(ChooseExtremePairs, PrefersTipsToNeighboursOnOneLimb)
{
  // Two points on either foot are exactly as alike as the hands and feet are; they are close to each other.
  const StickFigure figure = stickFigure(7, 9);
  const std::vector<Index> points = {figure.left_foot,      figure.left_foot - 1, figure.right_foot,
                                     figure.right_foot - 1, figure.left_hand,     figure.right_hand};
  const ExtremePairs pairs = chooseExtremePairs(points, std::vector<float>(figure.graph.size()),
                                                GeodesicMetric(figure.graph), everyThird(figure.graph));
  EXPECT_EQ(std::set<Index>({pairs.h1, pairs.h2}).count(figure.left_hand) +
                std::set<Index>({pairs.f1, pairs.f2}).count(figure.left_hand),
            1U);
}

TEST(ChooseExtremePairs, CostMoreWhereALimbHasNoCounterpart)
{
  const StickAnimal whole = stickAnimal(7, 8);
  const std::vector<float> feature(whole.graph.size());
  const std::vector<Index> landmarks = everyThird(whole.graph);
  const std::vector<Index> all = {whole.tail,       whole.head,      whole.left_fore,
                                  whole.right_fore, whole.left_hind, whole.right_hind};
  std::vector<Index> without_one = all;
  without_one.back() = 4; // in the middle of the back in place of a paw
  const GeodesicMetric metric(whole.graph);
  EXPECT_LT(chooseExtremePairs(all, feature, metric, landmarks).cost, 0.2F);
  EXPECT_GT(chooseExtremePairs(without_one, feature, metric, landmarks).cost, 0.34F);
}

TEST(ChooseExtremePairs, SurvivesPointsAtOnePlace)
{
  const SurfaceGraph graph = buildGraph(5, {{0, 1, 0.0F}, {1, 2, 0.0F}, {2, 3, 0.0F}, {3, 4, 0.0F}});
  const ExtremePairs pairs =
      chooseExtremePairs({0, 1, 2, 3, 4}, std::vector<float>(graph.size()), GeodesicMetric(graph), {0, 4});
  EXPECT_EQ((std::set<Index>{pairs.h1, pairs.h2, pairs.f1, pairs.f2}), (std::set<Index>{0, 1, 2, 3}));
}
