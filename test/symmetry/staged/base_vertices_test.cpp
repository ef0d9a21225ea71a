#include "support/with_threads.h"
#include "symmetry/staged/base_vertices.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

/** Eleven points on a line, one apart, and how far they are from each other. */
class BaseVerticesTest : public testing::Test {
protected:
  BaseVerticesTest() : metric_(line()), base_(metric_)
  {
  }

  static const std::vector<Vector3>&
  line()
  {
    static const std::vector<Vector3> points = [] {
      std::vector<Vector3> made;
      for (int i = 0; i <= 10; ++i) {
        made.push_back({static_cast<float>(i), 0.0F, 0.0F});
      }
      return made;
    }();
    return points;
  }

  EuclideanMetric metric_;
  BaseVertices base_;
};

std::vector<SymmetricMatch>
pairsOf(Index source, Index target)
{
  SymmetricMatch pair;
  pair.source = source;
  pair.target = target;
  return {pair};
}

TEST_F(BaseVerticesTest, APairGetsItsMidpoint)
{
  std::vector<SymmetricMatch> pairs = pairsOf(2, 8);
  base_.addPairs(pairs);
  EXPECT_EQ(pairs[0].midpoint, 5);
  EXPECT_EQ(base_.dimensions(), 2U);
  EXPECT_EQ(base_.sourceFields().row(0)[10], 8.0F);
  EXPECT_EQ(base_.targetFields().row(0)[10], 2.0F);
  EXPECT_EQ(base_.midpointFields().row(0)[10], 5.0F);
}

TEST_F(BaseVerticesTest, PartnersHaveEqualFeaturesEachSeenFromItsOwnSide)
{
  std::vector<SymmetricMatch> pairs = pairsOf(2, 8);
  base_.addPairs(pairs);
  const FeatureVectors left = base_.features({0, 1, 4}, Side::Source, FeatureSet::OwnEndpointsAndMidpoints);
  const FeatureVectors right = base_.features({10, 9, 6}, Side::Target, FeatureSet::OwnEndpointsAndMidpoints);
  EXPECT_EQ(left.values, (std::vector<float>{2, 5, 1, 4, 2, 1}));
  EXPECT_EQ(left.values, right.values);
  EXPECT_NE(base_.features({10}, Side::Source, FeatureSet::OwnEndpointsAndMidpoints).values,
            base_.features({10}, Side::Target, FeatureSet::OwnEndpointsAndMidpoints).values);
}

TEST_F(BaseVerticesTest, MidpointsAloneDoNotTellTheSides)
{
  std::vector<SymmetricMatch> pairs = pairsOf(2, 8);
  base_.addPairs(pairs);
  base_.addMidpoint(4);
  EXPECT_EQ(base_.dimensions(), 3U);
  const FeatureVectors features = base_.features({0}, Side::Source, FeatureSet::Midpoints);
  EXPECT_EQ(features.values, (std::vector<float>{5, 4}));
  EXPECT_EQ(base_.features({0}, Side::Target, FeatureSet::Midpoints).values, features.values);
}

TEST_F(BaseVerticesTest, FloorsAreSharesOfTheLargestDistanceOnTheSurface)
{
  std::vector<SymmetricMatch> pairs = pairsOf(2, 8);
  base_.addPairs(pairs);
  const std::vector<float> floors = base_.floors(Side::Source, FeatureSet::OwnEndpointsAndMidpoints);
  ASSERT_EQ(floors.size(), 2U);
  EXPECT_FLOAT_EQ(floors[0], 8.0F * feature_floor_share);
  EXPECT_FLOAT_EQ(floors[1], 5.0F * feature_floor_share);
}

TEST_F(BaseVerticesTest, DoNotDependOnTheNumberOfThreads)
{
  BaseVertices shared(metric_);
  std::vector<SymmetricMatch> pairs = pairsOf(1, 9);
  std::vector<SymmetricMatch> again = pairs;
  base_.addPairs(pairs);
  test::withThreads(3, [&] { shared.addPairs(again); });
  const std::vector<Index> all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(base_.features(all, Side::Source, FeatureSet::OwnEndpointsAndMidpoints).values,
            shared.features(all, Side::Source, FeatureSet::OwnEndpointsAndMidpoints).values);
}

} // namespace
