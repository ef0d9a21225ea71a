#include "base/statistics.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(Median, IsTheUpperOneOfTheMiddleTwo)
{
  EXPECT_EQ(median(std::vector<int>{5, 1, 3}), 3);
  EXPECT_EQ(median(std::vector<int>{4, 1, 3, 2}), 3);
  EXPECT_EQ(median(std::vector<double>{7.0}), 7.0);
  EXPECT_EQ(median(std::vector<float>{}), 0.0F);
}

TEST(Quantile, HasThatShareOfTheNumbersBelowIt)
{
  std::vector<int> numbers;
  for (int i = 0; i < 100; ++i) {
    numbers.push_back((i * 37) % 100); // each of 0 .. 99 once
  }
  EXPECT_EQ(quantile(numbers, 0.0), 0);
  EXPECT_EQ(quantile(numbers, 0.9), 90);
  EXPECT_EQ(quantile(numbers, 0.999), 99);
  EXPECT_EQ(quantile(numbers, 1.0), 99);
  EXPECT_EQ(quantile(std::vector<int>{}, 0.5), 0);
}

TEST(Quantile, InPlaceIsTheSameNumber)
{
  std::vector<int> numbers{9, 3, 7, 1, 5};
  EXPECT_EQ(quantileInPlace(numbers, 0.25), quantile(std::vector<int>{9, 3, 7, 1, 5}, 0.25));
  EXPECT_EQ(medianInPlace(numbers), 5);
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(numbers, (std::vector<int>{1, 3, 5, 7, 9})); // none lost, none twice
}

} // namespace
