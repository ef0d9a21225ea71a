#include "symmetry/staged/feature_vectors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

TEST(FeatureVectors, AreRowsOfOneMatrix)
{
  const FeatureVectors features{3, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(features.rows(), 2U);
  EXPECT_EQ(features.row(1)[0], 4.0F);
  EXPECT_EQ(FeatureVectors{}.rows(), 0U);
}

TEST(FeatureWeight, IsTheInverseDownToAFloor)
{
  EXPECT_FLOAT_EQ(featureWeight(4.0F, 0.1F), 0.25F);
  EXPECT_FLOAT_EQ(featureWeight(0.01F, 0.1F), 10.0F);
  EXPECT_EQ(featureWeight(0.0F, 0.0F), 0.0F);
}

TEST(FeatureFloors, AreAShareOfTheMaximumOfEachFeature)
{
  const std::vector<float> floors = featureFloors({2, {1, 50, 3, 20, 2, 0}});
  ASSERT_EQ(floors.size(), 2U);
  EXPECT_FLOAT_EQ(floors[0], 3.0F * feature_floor_share);
  EXPECT_FLOAT_EQ(floors[1], 50.0F * feature_floor_share);
  EXPECT_TRUE(featureFloors({}).empty());
}

TEST(Dissimilarity, IsTheSumOfSquaresOfRelativeDifferences)
{
  const std::vector<float> floors = {0.5F, 0.5F, 0.5F};
  const float query[] = {2.0F, 0.25F, 4.0F};
  const float candidate[] = {1.0F, 0.5F, 4.0F};
  // (1 / 2)^2 + (0.25 / 0.5)^2: the second is below its floor.
  EXPECT_FLOAT_EQ(dissimilarity(query, candidate, floors), 0.5F);
  EXPECT_EQ(dissimilarity(query, query, floors), 0.0F);
  // The weights are those of the query: the other way round it is another number.
  EXPECT_FLOAT_EQ(dissimilarity(candidate, query, floors), 1.0F + 0.25F);
}

TEST(Dissimilarity, TakesAnyNumberOfFeatures)
{
  for (const std::size_t dimensions : {1U, 15U, 16U, 17U, 100U}) {
    const std::vector<float> query(dimensions, 2.0F);
    const std::vector<float> candidate(dimensions, 1.0F);
    EXPECT_FLOAT_EQ(dissimilarity(query.data(), candidate.data(), std::vector<float>(dimensions, 0.1F)),
                    0.25F * static_cast<float>(dimensions));
  }
}

} // namespace
