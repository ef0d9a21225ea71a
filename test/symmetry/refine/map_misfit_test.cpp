#include "symmetry/refine/map_misfit.h"

#include <gtest/gtest.h>

#include <vector>

using namespace pcl::symmetry;

namespace {

constexpr std::size_t patches = 100;

float
misfitOf(const std::vector<PatchFit>& fits)
{
  return logMisfit(fits, meanOf(fits), 1.0F);
}

/** Fits of patches of which some are turned. */
std::vector<PatchFit>
turnedFits(float usual, std::size_t disturbed, float of_disturbed)
{
  std::vector<PatchFit> fits(patches, PatchFit{0.005F, usual});
  for (std::size_t k = 0; k < disturbed; ++k) {
    fits[k].turn = of_disturbed;
  }
  return fits;
}

TEST(MapMisfit, GrowsWithTurnAndWithDistance)
{
  const float few = misfitOf(turnedFits(0.02F, 0, 0.0F));
  EXPECT_GT(misfitOf(turnedFits(0.03F, 0, 0.0F)), few);
  EXPECT_GT(misfitOf(turnedFits(0.02F, 10, 0.5F)), few) << "the median alone would not see it";
  std::vector<PatchFit> farther = turnedFits(0.02F, 0, 0.0F);
  for (PatchFit& fit : farther) {
    fit.distance = 0.01F;
  }
  EXPECT_GT(misfitOf(farther), few);
}

/** The same turn on average: all of it in one place, a contact, or everywhere. */
TEST(MapMisfit, IsLessWhereOnePlaceIsDisturbedThanWhereNothingFits)
{
  const std::vector<PatchFit> one_place = turnedFits(0.01F, 10, 0.31F);
  const std::vector<PatchFit> everywhere = turnedFits(0.04F, 0, 0.0F);
  ASSERT_NEAR(meanOf(one_place).turn, meanOf(everywhere).turn, 1e-5F);
  EXPECT_LT(misfitOf(one_place), misfitOf(everywhere) - 0.5F);
}

TEST(MapMisfit, OfExactPatchesIsFinite)
{
  EXPECT_GT(misfitOf(std::vector<PatchFit>(patches, PatchFit{0.0F, 0.0F})), -14.0F);
}

} // namespace
