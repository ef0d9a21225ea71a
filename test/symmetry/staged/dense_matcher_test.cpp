#include "support/with_threads.h"
#include "symmetry/staged/dense_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::symmetry;

namespace {

/** Distances from random base points to random points of a box: features as surfaces have them. */
FeatureVectors
distanceFeatures(std::size_t rows, std::size_t dimensions, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(0.0F, 1.0F);
  std::mt19937 base_random(7);
  std::vector<std::array<float, 3>> bases(dimensions);
  for (auto& base : bases) {
    base = {coordinate(base_random), coordinate(base_random), coordinate(base_random)};
  }
  FeatureVectors features;
  features.dimensions = dimensions;
  for (std::size_t row = 0; row < rows; ++row) {
    const float p[3] = {coordinate(random), coordinate(random), 0.1F * coordinate(random)};
    for (const auto& base : bases) {
      features.values.push_back(std::hypot(p[0] - base[0], p[1] - base[1], p[2] - base[2]));
    }
  }
  return features;
}

std::vector<FeatureMatch>
scan(const FeatureVectors& queries, const FeatureVectors& candidates, const std::vector<float>& floors)
{
  std::vector<FeatureMatch> matches(queries.rows());
  for (std::size_t q = 0; q < queries.rows(); ++q) {
    for (std::size_t c = 0; c < candidates.rows(); ++c) {
      const float d = dissimilarity(queries.row(q), candidates.row(c), floors);
      if (c == 0 || d < matches[q].dissimilarity) {
        matches[q] = {static_cast<std::ptrdiff_t>(c), d};
      }
    }
  }
  return matches;
}

void
expectEqual(const std::vector<FeatureMatch>& found, const std::vector<FeatureMatch>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].row, expected[i].row) << "query " << i;
    ASSERT_EQ(found[i].dissimilarity, expected[i].dissimilarity) << "query " << i;
  }
}

} // namespace

TEST(Dissimilarity, IsThePublishedFormula)
{
  const FeatureVectors features = distanceFeatures(2, 37, 1);
  const std::vector<float> no_floors(37, 0.0F);
  double expected = 0.0;
  for (std::size_t i = 0; i < 37; ++i) {
    const double rho = features.row(0)[i];
    expected += std::pow((rho - features.row(1)[i]) / rho, 2);
  }
  EXPECT_NEAR(dissimilarity(features.row(0), features.row(1), no_floors), expected, 1e-5 * expected);
  EXPECT_EQ(dissimilarity(features.row(0), features.row(0), no_floors), 0.0F);
}

TEST(Dissimilarity, StaysFiniteAtABaseVertex)
{
  FeatureVectors features;
  features.dimensions = 2;
  features.values = {0.0F, 1.0F, 0.5F, 1.0F, 0.0F, 0.0F};
  const std::vector<float> floors = featureFloors(features);
  ASSERT_FLOAT_EQ(floors[0], 0.01F);
  ASSERT_FLOAT_EQ(floors[1], 0.02F);
  EXPECT_FLOAT_EQ(dissimilarity(features.row(0), features.row(1), floors), 2500.0F);
  EXPECT_EQ(dissimilarity(features.row(2), features.row(2), {0.0F, 0.0F}), 0.0F);
}

class DenseMatcherDimensions : public testing::TestWithParam<int> {};

TEST_P(DenseMatcherDimensions, EqualsAScanOverAllCandidates)
{
  const auto dimensions = static_cast<std::size_t>(GetParam());
  const FeatureVectors candidates = distanceFeatures(1500, dimensions, 2);
  const FeatureVectors queries = distanceFeatures(400, dimensions, 3);
  const std::vector<float> floors = featureFloors(candidates);
  expectEqual(DenseMatcher(candidates, floors).match(queries), scan(queries, candidates, floors));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DenseMatcherDimensions, testing::Values(1, 3, 7, 8, 9, 40, 185));

TEST(DenseMatcher, GivesTiesToTheLowestCandidate)
{
  // Features on a coarse lattice: most candidates have several equals, most queries lie between some.
  FeatureVectors candidates = distanceFeatures(1200, 3, 4);
  FeatureVectors queries = distanceFeatures(300, 3, 5);
  for (float& value : candidates.values) {
    value = std::round(4.0F * value);
  }
  for (float& value : queries.values) {
    value = std::round(8.0F * value) / 2.0F;
  }
  const std::vector<float> floors = featureFloors(candidates);
  expectEqual(DenseMatcher(candidates, floors).match(queries), scan(queries, candidates, floors));
}

TEST(DenseMatcher, DoesNotDependOnTheNumberOfThreadsOrTheOrderOfQueries)
{
  const FeatureVectors candidates = distanceFeatures(1000, 20, 6);
  const FeatureVectors queries = distanceFeatures(1000, 20, 7);
  const std::vector<float> floors = featureFloors(candidates);
  const DenseMatcher matcher(candidates, floors);
  const std::vector<FeatureMatch> matches = matcher.match(queries);
  expectEqual(test::withThreads(4, [&] { return matcher.match(queries); }), matches);

  FeatureVectors reversed;
  reversed.dimensions = queries.dimensions;
  for (std::size_t i = queries.rows(); i-- > 0;) {
    reversed.values.insert(reversed.values.end(), queries.row(i), queries.row(i) + queries.dimensions);
  }
  const std::vector<FeatureMatch> backwards = matcher.match(reversed);
  expectEqual({backwards.rbegin(), backwards.rend()}, matches);
}

TEST(DenseMatcher, FindsEveryCandidateItself)
{
  const FeatureVectors candidates = distanceFeatures(700, 12, 8);
  const std::vector<FeatureMatch> matches = DenseMatcher(candidates, featureFloors(candidates)).match(candidates);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    EXPECT_EQ(matches[i].row, static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(matches[i].dissimilarity, 0.0F);
  }
}

TEST(DenseMatcher, AnswersMinusOneWithoutCandidates)
{
  FeatureVectors none;
  none.dimensions = 5;
  const FeatureVectors queries = distanceFeatures(3, 5, 9);
  for (const FeatureMatch& match : DenseMatcher(none, std::vector<float>(5, 0.0F)).match(queries)) {
    EXPECT_EQ(match.row, -1);
  }
}
