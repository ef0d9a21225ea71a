// The PCL class: its result, its setters, what it refuses, its point types.
#include "estimation/class_runs.h"
#include "support/messages.h"

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/search/brute_force.h>

#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(IntrinsicSymmetryEstimation, AgreesWithTheFunctionWithoutPclTypes)
{
  const pcl::IntrinsicSymmetryResult result = compute(humanMesh());
  const SymmetryResult expected = estimateIntrinsicSymmetry(bentHuman().surface, staged());
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.partners, expected.partners);
  EXPECT_EQ(result.confidences, expected.confidences);
  EXPECT_EQ(result.sides, expected.sides);
}

TEST(IntrinsicSymmetryEstimation, TheAxisNeedNotBeLabelled)
{
  SymmetryParameters parameters = staged();
  const SymmetryResult labelled = estimateIntrinsicSymmetry(bentHuman().surface, parameters);
  parameters.label_axis = false;
  const SymmetryResult result = estimateIntrinsicSymmetry(bentHuman().surface, parameters);
  EXPECT_GT(labelled.map.axis, 0U);
  EXPECT_EQ(result.map.axis, 0U);
  EXPECT_EQ(result.axis.size(), labelled.axis.size());
  for (std::size_t v = 0; v < result.sides.size(); ++v) {
    EXPECT_TRUE(result.sides[v] == Side::Source || result.sides[v] == Side::Target);
    EXPECT_TRUE(labelled.sides[v] == Side::Axis || labelled.sides[v] == result.sides[v]);
  }
}

TEST(IntrinsicSymmetryEstimation, CorrespondencesAreTheMatches)
{
  const pcl::IntrinsicSymmetryResult result = compute(humanMesh());
  ASSERT_FALSE(result.matches.empty());
  ASSERT_EQ(result.correspondences.size(), result.matches.size());
  for (std::size_t i = 0; i < result.matches.size(); ++i) {
    EXPECT_EQ(result.correspondences[i].index_query, result.matches[i].source);
    EXPECT_EQ(result.correspondences[i].index_match, result.matches[i].target);
    EXPECT_EQ(result.correspondences[i].distance, result.matches[i].cost);
  }
}

TEST(IntrinsicSymmetryEstimation, AResultIsReplacedAsAWhole)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  const pcl::IntrinsicSymmetryResult first = result;
  estimation.compute(result);
  EXPECT_EQ(result.partners, first.partners);
  EXPECT_EQ(result.matches.size(), first.matches.size());
  EXPECT_EQ(result.correspondences.size(), first.correspondences.size());
  EXPECT_EQ(result.axis.size(), first.axis.size());
  EXPECT_EQ(result.seconds.size(), first.seconds.size());
}

TEST(IntrinsicSymmetryEstimation, RefusesToComputeWithoutInput)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  pcl::IntrinsicSymmetryResult result;
  EXPECT_THROW(estimation.compute(result), pcl::InitFailedException);
}

TEST(IntrinsicSymmetryEstimation, RefusesIndicesOutOfRangeAndRepeated)
{
  const auto n = static_cast<Index>(bentHuman().surface.size());
  expectInMessage(messageOf<pcl::BadArgumentException>([n] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{0, n}));
                  }),
                  {std::to_string(n), "range"});
  expectInMessage(messageOf<pcl::BadArgumentException>([] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{0, -1}));
                  }),
                  {"-1", "range"});
  expectInMessage(messageOf<pcl::BadArgumentException>([] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{4, 17, 4}));
                  }),
                  {"4", "twice"});
}

TEST(IntrinsicSymmetryEstimation, SettersRefuseWhatIsOutOfRangeAndKeepWhatTheyHad)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  EXPECT_EQ(estimation.getKSearch(), 10);
  for (const int k : {-1, 0, 2, 257}) {
    expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setKSearch(k); }),
                    {"k_search is " + std::to_string(k), "3", "256"});
  }
  EXPECT_EQ(estimation.getKSearch(), 10);
  estimation.setKSearch(3);
  EXPECT_EQ(estimation.getKSearch(), 3);
  estimation.setKSearch(256);
  EXPECT_EQ(estimation.getParameters().k_search, 256);
  SymmetryParameters parameters;
  parameters.staged.landmarks = 9;
  EXPECT_THROW(estimation.setParameters(parameters), pcl::BadArgumentException);
  EXPECT_EQ(estimation.getParameters().staged.landmarks, 100);
}

TEST(IntrinsicSymmetryEstimation, GettersMirrorSetters)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setNumberOfThreads(3);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3U);
  EXPECT_EQ(estimation.getParameters().threads, 3U);
  estimation.setMethod(Method::Staged);
  EXPECT_EQ(estimation.getMethod(), Method::Staged);
  const auto search = pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>();
  estimation.setSearchMethod(search);
  EXPECT_EQ(estimation.getSearchMethod(), search);
}

template <typename PointT>
class PointTypeTest : public testing::Test {
};

using PointTypes = testing::Types<pcl::PointXYZ,
                                  pcl::PointXYZI,
                                  pcl::PointXYZL,
                                  pcl::PointXYZRGB,
                                  pcl::PointXYZRGBA,
                                  pcl::PointXYZRGBL,
                                  pcl::PointNormal,
                                  pcl::PointXYZINormal,
                                  pcl::PointXYZRGBNormal>;
TYPED_TEST_SUITE(PointTypeTest, PointTypes);

TYPED_TEST(PointTypeTest, GivesTheSameMap)
{
  const pcl::IntrinsicSymmetryResult result = compute<TypeParam>(humanMesh());
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.partners, compute<pcl::PointXYZ>(humanMesh()).partners);
}

} // namespace
