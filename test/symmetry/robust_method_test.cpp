#include "base/vector_math.h"
#include "support/quadruped.h"
#include "symmetry/robust_method.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Of a search that makes no hypothesis. */
MapEstimate
estimateFrom(const std::vector<std::vector<Index>>& known, RobustSettings settings = {})
{
  settings.search.sign_patterns = false;
  settings.search.pairings = 0;
  StepTimer timer;
  return estimateRobust(quadruped().surface, SymmetryParameters{}, settings, timer, known);
}

TEST(RobustMethod, FindsNothingWithoutHypotheses)
{
  EXPECT_TRUE(estimateFrom({}).partners.empty());
}

TEST(RobustMethod, TriesTheMapsThatOthersHaveFound)
{
  const CoarseBody& body = quadruped();
  const std::vector<Index>& truth = body.model.partners;
  const std::vector<Index> nowhere(truth.size(), no_index);
  const MapEstimate estimate = estimateFrom({nowhere, truth});
  ASSERT_EQ(estimate.partners.size(), truth.size());
  const auto near = static_cast<double>(0.05F * body.landmarks.diameter);
  std::size_t right = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const Vector3& there = body.surface.points[truth[v]];
    right += distance(body.surface.points[estimate.partners[v]], there) < near ? 1U : 0U;
  }
  EXPECT_GT(right, truth.size() * 9 / 10);
}

TEST(RobustMethod, RefinesNothingWhereTheScoreIsNotBeaten)
{
  const std::vector<Index>& truth = quadruped().model.partners;
  const MapEstimate found = estimateFrom({truth});
  ASSERT_LT(found.search_score, 0.0F);
  RobustSettings settings;
  settings.score_to_beat = found.search_score + 0.01F;
  EXPECT_EQ(estimateFrom({truth}, settings).partners, found.partners);
  settings.score_to_beat = found.search_score;
  const MapEstimate none = estimateFrom({truth}, settings);
  EXPECT_EQ(none.status, SymmetryStatus::NoSymmetry);
  EXPECT_FALSE(none.message.empty());
  EXPECT_TRUE(none.partners.empty());
}

} // namespace
