#include "io/sample_result.h"
#include "symmetry/names/exchanged_sides.h"
#include "symmetry/sides/mirror_plane.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

SymmetryResult
roofWithAll()
{
  SymmetryResult result = roofSymmetry();
  result.extremities = {0, 4, 1, 5};
  std::vector<Vector3> moved = roof().points;
  for (Vector3& p : moved) {
    p[0] += 2.0F;
  }
  result.plane = fitMirrorPlane(moved, result.partners, result.sides);
  return result;
}

TEST(ExchangedSides, AreExchangedWhereverAResultSpeaksOfThem)
{
  const SymmetryResult before = roofWithAll();
  SymmetryResult after = before;
  exchangeSides(after);
  EXPECT_EQ(after.sides,
            (std::vector<Side>{Side::Target, Side::Target, Side::Axis, Side::Axis, Side::Source, Side::Source}));
  EXPECT_EQ(after.regions, (std::vector<Region>{Region::Target1, Region::Target2, Region::Centre, Region::None,
                                                Region::Source1, Region::Source2}));
  EXPECT_EQ(after.extremities, (std::vector<Index>{4, 0, 5, 1}));
  EXPECT_EQ(after.partners, before.partners);
  ASSERT_EQ(after.matches.size(), before.matches.size());
  EXPECT_EQ(after.matches[0].source, before.matches[0].target);
  EXPECT_EQ(after.matches[0].midpoint, before.matches[0].midpoint);
  EXPECT_EQ(after.axis[0].curve[0].across, (Vector3{1.0F, -0.0F, -0.0F}));
}

TEST(ExchangedSides, PlaneFacesTheNewSourceSide)
{
  SymmetryResult result = roofWithAll();
  ASSERT_NEAR(result.plane.normal[0], -1.0, 1e-6);
  exchangeSides(result);
  EXPECT_NEAR(result.plane.normal[0], 1.0, 1e-6);
  EXPECT_NEAR(result.plane.offset, 2.0, 1e-6);
  // Points of the source side, now those where x is above 2, are brought to where x is positive.
  const auto& row = result.plane.to_x[0];
  EXPECT_NEAR(row[0] * 3.0 + row[3], 1.0, 1e-6);
}

TEST(ExchangedSides, TwiceIsAsBefore)
{
  const SymmetryResult before = roofWithAll();
  SymmetryResult after = before;
  exchangeSides(after);
  exchangeSides(after);
  EXPECT_EQ(after.sides, before.sides);
  EXPECT_EQ(after.plane.normal, before.plane.normal);
  EXPECT_EQ(after.plane.to_x, before.plane.to_x);
}

} // namespace
