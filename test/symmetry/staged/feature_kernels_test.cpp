#include "symmetry/staged/feature_kernels.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(SumOfSquares, IsThatOfAllDifferences)
{
  const auto number = [](std::size_t i) {
    return static_cast<float>(i);
  };
  EXPECT_EQ(sumOfSquares(0, number), 0.0F);
  EXPECT_EQ(sumOfSquares(feature_lanes, number), 1240.0F); // 15 * 16 * 31 / 6
  EXPECT_EQ(sumOfSquares(2 * feature_lanes, number), 10416.0F);
}

TEST(SumOfSquares, AddsUpInLanesAndTheseByHalves)
{
  // In the order of the numbers each 1 would be lost beside 2^24; its own lane keeps them, and they add up first.
  const auto difference = [](std::size_t i) {
    return i == 0 ? 4096.0F : i % feature_lanes == 1 ? 1.0F : 0.0F;
  };
  EXPECT_EQ(sumOfSquares(4 * feature_lanes, difference), 16777216.0F + 4.0F);
}

TEST(SumOfSquares, AsksForEachDifferenceOnce)
{
  std::size_t calls = 0;
  sumOfSquares(3 * feature_lanes, [&](std::size_t i) {
    EXPECT_EQ(i, calls++);
    return 0.0F;
  });
  EXPECT_EQ(calls, 3 * feature_lanes);
}

} // namespace
