#include "support/graphs.h"
#include "symmetry/staged/regions.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

TEST(LimbRegions, ReachFromTheExtremePointsToTheirMidpoints)
{
  // A strip: h1 and h2 at the ends of the lower row, f1 and f2 further in on the upper one.
  const SurfaceGraph strip = meshGraph(gridMesh(21, 2));
  const DistanceFields source = distanceFields(strip, {0, 21 + 8});
  const DistanceFields target = distanceFields(strip, {20, 21 + 12});
  const Index m_h = 5; // not half way: the limbs are as long as this midpoint says
  const Index m_f = 21 + 10;
  const std::vector<Region> regions = limbRegions(source, target, m_h, m_f);
  for (std::size_t v = 0; v < regions.size(); ++v) {
    const float h1 = source.row(0)[v] / source.row(0)[m_h];
    const float h2 = target.row(0)[v] / target.row(0)[m_h];
    const float f1 = source.row(1)[v] / source.row(1)[m_f];
    const float f2 = target.row(1)[v] / target.row(1)[m_f];
    const float least = std::min({h1, h2, f1, f2});
    switch (regions[v]) {
    case Region::Source1:
      EXPECT_TRUE(h1 < 1.0F && h1 == least);
      break;
    case Region::Target1:
      EXPECT_TRUE(h2 < 1.0F && h2 == least);
      break;
    case Region::Source2:
      EXPECT_TRUE(f1 < 1.0F && f1 == least);
      break;
    case Region::Target2:
      EXPECT_TRUE(f2 < 1.0F && f2 == least);
      break;
    case Region::Centre:
      EXPECT_GE(least, 1.0F);
      break;
    case Region::None:
      ADD_FAILURE() << "vertex " << v << " has no region";
    }
  }
  EXPECT_EQ(regions[0], Region::Source1);
  EXPECT_EQ(regions[20], Region::Target1);
  EXPECT_EQ(regions[21 + 8], Region::Source2);
  EXPECT_EQ(regions[21 + 12], Region::Target2);
  EXPECT_EQ(regions[m_f], Region::Target1); // on the rim of the second limbs, but within the first target limb
}

TEST(LimbRegions, OfLengthZeroHoldNothing)
{
  const SurfaceGraph strip = meshGraph(gridMesh(5, 2));
  const DistanceFields source = distanceFields(strip, {0, 5});
  const DistanceFields target = distanceFields(strip, {4, 9});
  const std::vector<Region> regions = limbRegions(source, target, 0, 5); // the midpoints are h1 and f1 themselves
  EXPECT_EQ(std::count(regions.begin(), regions.end(), Region::Source1), 0);
  EXPECT_EQ(std::count(regions.begin(), regions.end(), Region::Source2), 0);
}
