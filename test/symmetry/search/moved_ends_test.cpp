#include "support/quadruped.h"
#include "symmetry/search/moved_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const LandmarkSurface&
landmarks()
{
  return quadruped().landmarks;
}

std::vector<Index>
ends()
{
  return extremitiesOf(landmarks(), limb_separation, most_limbs);
}

SampleMap
identity()
{
  SampleMap map(landmarks().size());
  std::iota(map.begin(), map.end(), 0);
  return map;
}

/** Four legs of seven ends; head, tail and one more lie on the axis. */
TEST(MovedEnds, ALeftToRightMapMovesTheLegs)
{
  ASSERT_EQ(ends().size(), 7U);
  EXPECT_EQ(MovedEnds(landmarks()).share(identity()), 0.0F);
  EXPECT_FLOAT_EQ(MovedEnds(landmarks()).share(quadruped().trueMap()), 4.0F / 5.0F);
}

TEST(MovedEnds, TwoThatStandStillAreMissing)
{
  SampleMap map = quadruped().trueMap();
  std::vector<Index> moving = ends();
  moving.erase(std::remove_if(moving.begin(), moving.end(),
                              [&](Index end) {
                                return landmarks().distances(end, map[end]) <= limb_separation * landmarks().diameter;
                              }),
               moving.end());
  ASSERT_GE(moving.size(), 4U);
  for (const Index end : {moving[0], map[moving[0]]}) {
    map[end] = end;
  }
  const auto all_but_two = static_cast<float>(ends().size() - 2);
  const std::ptrdiff_t still_moving = std::count_if(moving.begin(), moving.end(), [&](Index end) {
    return landmarks().distances(end, map[end]) > limb_separation * landmarks().diameter;
  });
  ASSERT_LT(still_moving, static_cast<std::ptrdiff_t>(moving.size()));
  EXPECT_FLOAT_EQ(MovedEnds(landmarks()).share(map), static_cast<float>(still_moving) / all_but_two);
}

TEST(MovedEnds, HeadAndTailMayMoveAsWell)
{
  // Every end to the next one: nothing stays where it is.
  SampleMap map = identity();
  const std::vector<Index> of_limbs = ends();
  for (std::size_t i = 0; i < of_limbs.size(); ++i) {
    map[of_limbs[i]] = of_limbs[(i + 1) % of_limbs.size()];
  }
  EXPECT_EQ(MovedEnds(landmarks()).share(map), 1.0F) << "no more than that";
}

TEST(MovedEnds, TellsNothingOfTwoEnds)
{
  // A rod: distances along a line.
  LandmarkSurface rod;
  constexpr Eigen::Index count = 41;
  rod.distances.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      rod.distances(i, j) = static_cast<float>(std::abs(i - j));
    }
    rod.average_distance.push_back(rod.distances.row(i).mean());
    rod.points.push_back({static_cast<float>(i), 0.0F, 0.0F});
  }
  rod.diameter = static_cast<float>(count - 1);
  ASSERT_EQ(extremitiesOf(rod, limb_separation, most_limbs).size(), 2U);
  SampleMap turned(count);
  std::iota(turned.rbegin(), turned.rend(), 0);
  EXPECT_EQ(MovedEnds(rod).share(turned), 0.0F);
}

} // namespace
