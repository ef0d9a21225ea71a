#include "benchmark/confidence_metrics.h"
#include "benchmark/runs.h"

#include <gtest/gtest.h>

#include <random>

namespace pcl {
namespace symmetry {
namespace {

/** The definition: the share of pairs of a right and a wrong one in which the right one is more confident. */
double
bruteForceArea(const std::vector<Judgement>& judgements)
{
  double pairs = 0.0;
  double won = 0.0;
  for (const Judgement& right : judgements)
    for (const Judgement& wrong : judgements) {
      if (!right.right || wrong.right)
        continue;
      pairs += 1.0;
      won += right.confidence > wrong.confidence ? 1.0 : right.confidence == wrong.confidence ? 0.5 : 0.0;
    }
  return won / pairs;
}

TEST(ConfidenceMetricsTest, AreaUnderRocOfKnownCases)
{
  EXPECT_EQ(areaUnderRoc({{0.9, true}, {0.8, true}, {0.1, false}}), 1.0);
  EXPECT_EQ(areaUnderRoc({{0.1, true}, {0.9, false}}), 0.0);
  EXPECT_EQ(areaUnderRoc({{0.5, true}, {0.5, false}, {0.5, true}}), 0.5);
  EXPECT_EQ(areaUnderRoc({{0.5, true}, {0.6, true}}), std::nullopt);
  EXPECT_EQ(areaUnderRoc({{0.5, false}}), std::nullopt);
  EXPECT_EQ(areaUnderRoc({}), std::nullopt);
}

TEST(ConfidenceMetricsTest, AreaUnderRocAgreesWithItsDefinition)
{
  std::mt19937 random(3);
  std::vector<Judgement> judgements;
  for (int i = 0; i < 200; ++i) {
    const bool right = random() % 3 != 0;
    judgements.push_back({0.1 * static_cast<double>(random() % 8 + (right ? 3 : 0)), right});
  }
  const double expected = bruteForceArea(judgements);
  EXPECT_GT(expected, 0.6);
  EXPECT_LT(expected, 0.95);
  EXPECT_NEAR(*areaUnderRoc(judgements), expected, 1e-12);
}

TEST(ConfidenceMetricsTest, CoverageCurveTakesTheMostConfidentFirst)
{
  const std::vector<CoveragePoint> curve = coverageCurve({{0.2, false}, {0.9, true}, {0.3, false}, {0.8, true}}, 4);
  ASSERT_EQ(curve.size(), 4U);
  EXPECT_DOUBLE_EQ(curve[0].coverage, 0.25);
  EXPECT_DOUBLE_EQ(curve[0].accuracy, 1.0);
  EXPECT_DOUBLE_EQ(curve[1].accuracy, 1.0);
  EXPECT_DOUBLE_EQ(curve[2].accuracy, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve[3].accuracy, 0.5);
  EXPECT_TRUE(coverageCurve({}, 4).empty());
}

TEST(ConfidenceMetricsTest, EqualConfidencesCountAlike)
{
  for (const CoveragePoint& point : coverageCurve({{0.5, true}, {0.5, false}, {0.5, false}, {0.5, true}}, 8))
    EXPECT_DOUBLE_EQ(point.accuracy, 0.5) << point.coverage;
}

TEST(ConfidenceMetricsTest, JudgesWhatHasAMapAndAScore)
{
  ModelRun without_map = test::makeRun("KIDS", "kids", "none", 0);
  without_map.score->map_size = 0;
  without_map.partners.assign(4, no_index);
  const std::vector<ModelRun> runs{test::makeRun("KIDS", "kids", "good", 4), test::makeRun("KIDS", "kids", "bad", 3),
                                   test::makeFailedRun("KIDS", "kids", "failed"),
                                   test::makeUnscoredRun("clouds", "horse"), without_map};
  const std::vector<Judgement> all = judgeMaps(runs, JudgedRuns::All);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FALSE(all[2].right) << "no map is no right one";
  const std::vector<Judgement> maps = judgeMaps(runs, JudgedRuns::Delivered);
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].confidence, 1.0);
  EXPECT_TRUE(maps[0].right);
  EXPECT_FALSE(maps[1].right) << "three of four are not more than 75 %";

  const std::vector<Judgement> vertices = judgeVertices(runs);
  ASSERT_EQ(vertices.size(), 8U);
  EXPECT_FLOAT_EQ(static_cast<float>(vertices[7].confidence), 0.6F);
  EXPECT_TRUE(vertices[6].right);
  EXPECT_FALSE(vertices[7].right);
}

} // namespace
} // namespace symmetry
} // namespace pcl
