#include "benchmark/runs.h"
#include "benchmark/summary.h"

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace {

/** Two classes of different size, a failure, and one model without ground truth. */
std::vector<ModelRun>
makeRuns()
{
  return {test::makeRun("TOSCA", "cat", "cat0", 4), test::makeRun("TOSCA", "cat", "cat1", 2),
          test::makeRun("TOSCA", "dog", "dog0", 4), test::makeFailedRun("KIDS", "kids", "a"),
          test::makeUnscoredRun("clouds", "horse")};
}

TEST(SummaryTest, ClassesAreMeansOfTheirModels)
{
  const std::vector<GroupSummary> classes = summariseClasses(makeRuns());
  ASSERT_EQ(classes.size(), 3U) << "what has no ground truth is left out";
  EXPECT_EQ(classes[0].set + classes[0].class_name, "TOSCAcat");
  EXPECT_EQ(classes[0].models, 2U);
  EXPECT_EQ(classes[0].symmetric, 2U);
  EXPECT_DOUBLE_EQ(classes[0].correspondence_rate, 0.75);
  EXPECT_DOUBLE_EQ(classes[0].mesh_rate, 0.5);
  EXPECT_DOUBLE_EQ(classes[0].mean_geodesic_error, 0.05);
  EXPECT_DOUBLE_EQ(classes[0].below[2], 0.75) << "below 0.15";
  EXPECT_DOUBLE_EQ(classes[0].below[4], 1.0) << "below 0.25";
  EXPECT_DOUBLE_EQ(classes[0].mean_confidence, 0.75);
  EXPECT_DOUBLE_EQ(classes[0].mean_seconds, 1.5);
}

TEST(SummaryTest, AFailureCountsAsWrong)
{
  const GroupSummary kids = summariseClasses(makeRuns())[2];
  EXPECT_EQ(kids.failed, 1U);
  EXPECT_EQ(kids.symmetric, 0U);
  EXPECT_EQ(kids.correspondence_rate, 0.0);
  EXPECT_EQ(kids.mesh_rate, 0.0);
  EXPECT_EQ(kids.mean_geodesic_error, 1.0);
}

TEST(SummaryTest, SetsAreMeansOfTheirClasses)
{
  const std::vector<GroupSummary> sets = summariseSets(summariseClasses(makeRuns()));
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0].set, "TOSCA");
  EXPECT_EQ(sets[0].models, 3U);
  EXPECT_DOUBLE_EQ(sets[0].correspondence_rate, 0.875) << "cats 0.75, dog 1; the mean of the models would be 0.833";
  EXPECT_DOUBLE_EQ(sets[0].mesh_rate, 0.75);
}

TEST(SummaryTest, CurvesRiseFromZeroToTheShareBelowTheLargestThreshold)
{
  const std::vector<ErrorCurve> curves = errorCurves(makeRuns(), 0.25, 5);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].name, "TOSCA");
  EXPECT_EQ(curves[0].thresholds.size(), 6U);
  EXPECT_DOUBLE_EQ(curves[0].thresholds[1], 0.05);
  EXPECT_EQ(curves[0].shares[0], 0.0) << "no error is below 0";
  EXPECT_NEAR(curves[0].shares[1], 0.875, 1e-12) << "cats 0.75, dog 1, as in the summary of the set";
  EXPECT_NEAR(curves[0].shares[5], 1.0, 1e-12);
  EXPECT_EQ(curves[1].shares[5], 0.0) << "a failure has no point";
}

TEST(SummaryTest, AVariantIsComparedWithItsModel)
{
  std::vector<ModelRun> runs{test::makeRun("A", "c", "m", 4),          test::makeRun("A", "c", "m~shuffled", 4),
                             test::makeRun("A", "c", "m~half", 1),     test::makeRun("A", "c", "n", 4),
                             test::makeRun("A", "c", "n~shuffled", 4), test::makeRun("A", "c", "n~half", 4)};
  for (const std::size_t i : {1U, 4U})
    runs[i].model.variant = Variant::Shuffled;
  for (const std::size_t i : {2U, 5U})
    runs[i].model.variant = Variant::Half;
  runs[2].confidence = 0.7F;
  runs[4].status = SymmetryStatus::NoSymmetry;
  const std::vector<VariantSummary> summaries = summariseVariants(runs);
  ASSERT_EQ(summaries.size(), 3U);
  EXPECT_EQ(summaries[0].variant, Variant::AsItIs);
  EXPECT_EQ(summaries[0].right, 2U);
  EXPECT_EQ(summaries[0].alike, 2U);
  EXPECT_EQ(summaries[1].refused, 1U);
  EXPECT_EQ(summaries[1].alike, 1U);
  EXPECT_EQ(summaries[2].right, 1U);
  EXPECT_EQ(summaries[2].sure_but_wrong, 1U);
  EXPECT_EQ(summaries[2].models, 2U);
  EXPECT_DOUBLE_EQ(summaries[2].correspondence_rate, 0.625);
}

} // namespace
} // namespace symmetry
} // namespace pcl
