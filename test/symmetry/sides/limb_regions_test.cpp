#include "support/human.h"
#include "symmetry/sides/limb_regions.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** 1 or -1 for every landmark, 0 on the axis. */
std::vector<float>
trueSides()
{
  std::vector<float> sides;
  for (Index i = 0; i < static_cast<Index>(human().landmarks.size()); ++i) {
    sides.push_back(static_cast<float>(trueSide(i)));
  }
  return sides;
}

TEST(LimbRegions, LimbsOfTheTrueMapHoldOppositeSides)
{
  const SampleMap map = human().trueMap();
  const auto limbs = swappedExtremities(human().landmarks, map, trueSides());
  ASSERT_EQ(limbs.size(), 2U);
  EXPECT_EQ(trueSide(limbs[0].first), 1);
  EXPECT_EQ(trueSide(limbs[1].first), 1);
  EXPECT_EQ(trueSide(limbs[0].first), -trueSide(limbs[0].second));
  EXPECT_EQ(trueSide(limbs[1].first), -trueSide(limbs[1].second));

  const std::vector<Region> regions = limbRegions(human().landmarks, limbs);
  EXPECT_EQ(regions[limbs[0].first], Region::Source1);
  EXPECT_EQ(regions[limbs[0].second], Region::Target1);
  EXPECT_EQ(regions[limbs[1].first], Region::Source2);
  EXPECT_EQ(regions[limbs[1].second], Region::Target2);
  for (const auto& [source, target] : limbs) {
    for (Index i = 0; i < 250; ++i) {
      const float half_way = 0.5F * human().landmarks.distances(source, target);
      if (human().landmarks.distances(i, source) < half_way || human().landmarks.distances(i, target) < half_way) {
        EXPECT_NE(regions[i], Region::Centre) << i;
      }
    }
  }
}

TEST(LimbRegions, SourcesAreOnTheSourceSide)
{
  const SampleMap map = human().trueMap();
  std::vector<float> sides = trueSides();
  const auto limbs = swappedExtremities(human().landmarks, map, sides);
  for (float& side : sides) {
    side = -side;
  }
  const auto turned = swappedExtremities(human().landmarks, map, sides);
  ASSERT_EQ(limbs.size(), 2U);
  ASSERT_EQ(turned.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(trueSide(turned[k].first), trueSide(limbs[k].second));
    EXPECT_EQ(trueSide(turned[k].second), trueSide(limbs[k].first));
  }
}

TEST(LimbRegions, WithoutLimbsEverythingIsCentre)
{
  const std::vector<Region> regions = limbRegions(human().landmarks, {});
  EXPECT_EQ(regions, std::vector<Region>(250, Region::Centre));
}

} // namespace
