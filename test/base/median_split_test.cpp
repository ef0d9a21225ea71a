#include "base/median_split.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;

namespace {

TEST(SplitAtMedian, HalvesARangeAlongTheLongestSide)
{
  std::vector<Vector3> points;
  BoundingBox box;
  std::vector<Index> numbers;
  for (int i = 0; i < 11; ++i) {
    points.push_back({0.0F, static_cast<float>(i * 7 % 11), 0.1F * static_cast<float>(i % 3)});
    box.extend(points.back());
    numbers.push_back(static_cast<Index>(i));
  }
  const std::uint32_t middle = splitAtMedian(points, box, 0, 11, numbers);
  ASSERT_EQ(middle, 5U);
  for (std::uint32_t i = 0; i < middle; ++i) {
    EXPECT_LT(points[numbers[i]][1], points[numbers[middle]][1]);
  }
  for (std::uint32_t i = middle + 1; i < 11; ++i) {
    EXPECT_GT(points[numbers[i]][1], points[numbers[middle]][1]);
  }
}

TEST(SplitAtMedian, OrdersEqualPlacesByNumberAndLeavesTheRestAlone)
{
  const std::vector<Vector3> points(6, Vector3{1.0F, 1.0F, 1.0F});
  BoundingBox box;
  box.extend(points.front());
  std::vector<Index> numbers{5, 4, 3, 2, 1, 0};
  const std::uint32_t middle = splitAtMedian(points, box, 1, 5, numbers);
  ASSERT_EQ(middle, 3U);
  EXPECT_EQ(numbers.front(), 5);
  EXPECT_EQ(numbers.back(), 0);
  EXPECT_EQ(std::max(numbers[1], numbers[2]), 2);
  EXPECT_EQ(numbers[3], 3);
}

} // namespace
