#include "support/human.h"
#include "support/with_threads.h"
#include "symmetry/search/symmetry_search.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<SymmetryCandidate>
search(const CoarseBody& body, const SearchSettings& settings = {})
{
  return searchSymmetries(body.sampled(), settings);
}

/** The spectral coordinates of a map's landmarks under an action on them, mean squared distance to those of the images.
 */
float
misfit(const CoarseBody& body, const Eigen::MatrixXf& action, const SampleMap& map)
{
  const Eigen::MatrixXf functions = body.basis.functions.block(0, 1, 250, action.cols());
  Eigen::MatrixXf images(functions.rows(), functions.cols());
  for (Eigen::Index i = 0; i < images.rows(); ++i) {
    images.row(i) = functions.row(map[static_cast<std::size_t>(i)]);
  }
  return (functions * action - images).squaredNorm() / images.squaredNorm();
}

TEST(SignPatternHypotheses, AreAllDiagonalInvolutionsButTheIdentity)
{
  const std::vector<SymmetryHypothesis> hypotheses = signPatternHypotheses(5);
  ASSERT_EQ(hypotheses.size(), 31U);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const Eigen::MatrixXf& action = hypotheses[i].action;
    EXPECT_TRUE(action.isDiagonal());
    EXPECT_EQ((action * action - Eigen::MatrixXf::Identity(5, 5)).norm(), 0.0F);
    EXPECT_GT((action - Eigen::MatrixXf::Identity(5, 5)).norm(), 1.0F);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((action - hypotheses[j].action).norm(), 1.0F);
    }
  }
}

TEST(ExtremityHypotheses, AreInvolutionsAndOneOfThemIsTheTrueMap)
{
  const std::vector<SymmetryHypothesis> hypotheses = extremityHypotheses(human().landmarks, human().basis, 8, 40);
  ASSERT_FALSE(hypotheses.empty());
  ASSERT_LE(hypotheses.size(), 40U);
  const SampleMap truth = human().trueMap();
  float best = 2.0F;
  for (const SymmetryHypothesis& hypothesis : hypotheses) {
    EXPECT_LT((hypothesis.action * hypothesis.action - Eigen::MatrixXf::Identity(8, 8)).norm(), 1e-4F);
    best = std::min(best, misfit(human(), hypothesis.action, truth));
  }
  EXPECT_LT(best, 0.1F);
}

TEST(SymmetrySearch, FindsTheTrueMapOfAPosedBody)
{
  for (const Body kind : {Body::Human, Body::Quadruped, Body::Bird}) {
    SCOPED_TRACE(toString(kind));
    const CoarseBody body = coarseBody(kind, 1.0);
    const std::vector<SymmetryCandidate> candidates = search(body);
    ASSERT_FALSE(candidates.empty());
    EXPECT_LT(mapDifference(body.landmarks, candidates[0].map, body.trueMap()), 0.04F);
  }
}

TEST(SymmetrySearch, EachSourceOfHypothesesSuffices)
{
  SearchSettings only_patterns;
  only_patterns.pairings = 0;
  SearchSettings only_extremities;
  only_extremities.sign_patterns = false;
  for (const SearchSettings& settings : {only_patterns, only_extremities}) {
    const std::vector<SymmetryCandidate> candidates = search(human(), settings);
    ASSERT_FALSE(candidates.empty());
    EXPECT_LT(mapDifference(human().landmarks, candidates[0].map, human().trueMap()), 0.04F);
  }
}

TEST(SymmetrySearch, CandidatesAreDistinctMapsBestFirst)
{
  const std::vector<SymmetryCandidate> candidates = search(human());
  const SearchSettings settings;
  ASSERT_GE(candidates.size(), 2U);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ASSERT_EQ(candidates[i].map.size(), human().landmarks.size());
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LE(candidates[j].score.value, candidates[i].score.value);
      EXPECT_GE(mapDifference(human().landmarks, candidates[i].map, candidates[j].map), settings.distinct);
    }
  }
}

TEST(SymmetrySearch, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<SymmetryCandidate> one = search(human());
  const std::vector<SymmetryCandidate> five = withThreads(5, [] { return search(human()); });
  ASSERT_EQ(one.size(), five.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].map, five[i].map);
    EXPECT_EQ(one[i].score.value, five[i].score.value);
  }
}

} // namespace
