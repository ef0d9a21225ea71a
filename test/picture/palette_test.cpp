// Colours of the sides: told apart by everyone, also in grey.
#include "picture/palette.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

/** Relative luminance in [0, 1] of a colour in sRGB (Recommendation BT.709, without the linear foot). */
double
luminance(const Colour& colour)
{
  const auto linear = [](std::uint8_t channel) {
    return std::pow(channel / 255.0, 2.2);
  };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

TEST(Palette, SidesAreBlueOrangeAndDarkRed)
{
  const Colour source = colourOf(Side::Source);
  EXPECT_GT(source[2], source[0]);
  EXPECT_GT(source[2], source[1]);
  const Colour target = colourOf(Side::Target);
  EXPECT_GT(target[0], target[1]);
  EXPECT_GT(target[1], target[2]);
  const Colour axis = colourOf(Side::Axis);
  EXPECT_GT(axis[0], 3 * axis[1]);
  EXPECT_GT(axis[0], 3 * axis[2]);
  const Colour none = colourOf(Side::None);
  EXPECT_TRUE(none[0] == none[1] && none[1] == none[2]);
}

TEST(Palette, SidesDifferInBrightnessToo)
{
  // 1.5: well above what is seen side by side; the axis is darker than both sides.
  const double source = luminance(colourOf(Side::Source));
  const double target = luminance(colourOf(Side::Target));
  const double axis = luminance(colourOf(Side::Axis));
  EXPECT_GT(target, 1.5 * source);
  EXPECT_GT(source, 1.5 * axis);
}

TEST(Palette, AnUnknownSideIsGrey)
{
  EXPECT_EQ(colourOf(static_cast<Side>(200)), colourOf(Side::None));
}

} // namespace
