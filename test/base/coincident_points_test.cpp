#include "base/coincident_points.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

using namespace pcl::symmetry;

namespace {

TEST(FirstCoincident, IsTheOneThatASearchOfAllFinds)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-4, 4);
  std::vector<Vector3> points;
  for (int i = 0; i < 2000; ++i) {
    points.push_back({0.1F * static_cast<float>(coordinate(random)), 1e20F * static_cast<float>(coordinate(random)),
                      static_cast<float>(coordinate(random))});
  }
  std::map<Vector3, Index> first;
  const std::vector<Index> found = firstCoincident(points);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_EQ(found[v], first.emplace(points[v], static_cast<Index>(v)).first->second);
  }
}

TEST(FirstCoincident, KnowsOneZeroAndNoEqualOfWhatIsNotANumber)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(firstCoincident({{0.0F, 1.0F, 2.0F}, {-0.0F, 1.0F, 2.0F}, {nan, 0.0F, 0.0F}, {nan, 0.0F, 0.0F}}),
            (std::vector<Index>{0, 0, 2, 3}));
  EXPECT_TRUE(firstCoincident({}).empty());
}

} // namespace
