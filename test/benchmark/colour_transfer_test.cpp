#include "benchmark/colour_transfer.h"
#include "support/temporary_folder.h"

#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** A flat strip of four points from left to right, the outer two and the inner two partners. */
struct Strip {
  Surface surface;
  SymmetryResult result;

  Strip()
  {
    surface.points = {{0.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {2.0F, 1.0F, 0.0F}, {3.0F, 0.0F, 0.0F}};
    surface.triangles = {{0, 1, 2}, {0, 2, 3}};
    result.status = SymmetryStatus::Symmetric;
    result.partners = {3, 2, 1, 0};
    result.confidences.assign(4, 1.0F);
    result.support.assign(4, 1.0F);
    result.regions.assign(4, Region::None);
    result.sides = {Side::Source, Side::Source, Side::Target, Side::Target};
  }
};

TEST(ColourTransfer, PartnersHaveOneColourAndOthersDiffer)
{
  const Strip strip;
  const std::vector<Colour> colours = transferColours(strip.surface, strip.result);
  ASSERT_EQ(colours.size(), 4U);
  EXPECT_EQ(colours[3], colours[0]);
  EXPECT_EQ(colours[2], colours[1]);
  EXPECT_NE(colours[0], colours[1]);
  EXPECT_LT(colours[0][0], colours[1][0]) << "red grows along x";
}

TEST(ColourTransfer, AWrongPartnerShows)
{
  Strip strip;
  strip.result.partners = {2, 3, 0, 1};
  const std::vector<Colour> colours = transferColours(strip.surface, strip.result);
  EXPECT_EQ(colours[3], colours[1]);
  EXPECT_EQ(colours[2], colours[0]);
}

TEST(ColourTransfer, WhatHasNoSideOrPartnerOrPlaceIsGrey)
{
  Strip strip;
  strip.result.sides[0] = Side::None;
  strip.result.partners[2] = no_index;
  strip.surface.points[1][2] = std::numeric_limits<float>::quiet_NaN();
  strip.result.sides[3] = Side::Axis;
  const std::vector<Colour> colours = transferColours(strip.surface, strip.result);
  for (const std::size_t i : {0U, 1U, 2U})
    EXPECT_EQ(colours[i], colourOf(Side::None)) << i;
  EXPECT_NE(colours[3], colourOf(Side::None)) << "the axis is coloured by place";
}

class ColourTransferFile : public test::TemporaryFolder {};

TEST_F(ColourTransferFile, IsAPicture)
{
  const Strip strip;
  writeColourTransfer(path("a.png"), strip.surface, strip.result);
  EXPECT_EQ(read(path("a.png")).substr(1, 3), "PNG");
}

} // namespace
} // namespace symmetry
} // namespace pcl
