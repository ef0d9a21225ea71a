#include "base/renumbering.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(Renumbering, GivesWhatIsKeptConsecutiveNumbers)
{
  EXPECT_EQ(numbersOfKept({0, 1, 0, 1, 1}), (std::vector<Index>{no_index, 0, no_index, 1, 2}));
}

TEST(Renumbering, LeavesNoIndexAsItIs)
{
  EXPECT_EQ(renumbered({2, no_index, 0}, {7, 8, no_index}), (std::vector<Index>{no_index, no_index, 7}));
}

TEST(Renumbering, DropsTrianglesWithACornerThatIsGone)
{
  std::vector<Triangle> triangles = {{0, 1, 2}, {1, 2, 3}, {3, 2, 1}};
  renumberTriangles(triangles, {no_index, 5, 6, 7});
  EXPECT_EQ(triangles, (std::vector<Triangle>{{5, 6, 7}, {7, 6, 5}}));
}

TEST(Renumbering, TurnsATriangleWithoutTurningItOver)
{
  EXPECT_EQ(lowestFirst({1, 2, 0}), (Triangle{0, 1, 2}));
  EXPECT_EQ(lowestFirst({2, 1, 0}), (Triangle{0, 2, 1}));
  EXPECT_EQ(lowestFirst({0, 2, 1}), (Triangle{0, 2, 1}));
}

TEST(Renumbering, RestrictsAListAndSpreadsItAgain)
{
  std::vector<float> values = {0.0F, 1.0F, 2.0F, 3.0F};
  keepEntries(values, {1, 3});
  EXPECT_EQ(values, (std::vector<float>{1.0F, 3.0F}));
  scatter(values, {1, 3}, 4, -1.0F);
  EXPECT_EQ(values, (std::vector<float>{-1.0F, 1.0F, -1.0F, 3.0F}));
}

} // namespace
