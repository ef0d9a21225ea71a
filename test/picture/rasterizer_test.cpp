// Shapes on an image, compared pixel by pixel with what geometry says about the centre of each pixel.
#include "picture/rasterizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace pcl::symmetry;

namespace {

constexpr Colour white = {255, 255, 255};
constexpr Colour black = {0, 0, 0};
constexpr Colour red = {200, 0, 0};
constexpr Colour blue = {0, 0, 200};
constexpr int size = 32;

Colour
at(const Image& image, int x, int y)
{
  const auto i = 3 * static_cast<std::size_t>(y * image.width + x);
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

/** The weights of a triangle's corners need not add up to one to the last bit, and shades are rounded down. */
::testing::AssertionResult
isColour(const Colour& seen, const Colour& expected)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(seen[i] - expected[i]) > 1)
      return ::testing::AssertionFailure()
             << ::testing::PrintToString(seen) << " instead of " << ::testing::PrintToString(expected);
  return ::testing::AssertionSuccess();
}

/** Checks each pixel: \a inside tells by the distance of its centre to the border whether a shape covers it, positive
 * inside; within \a tolerance of the border either will do. */
template <typename Inside>
void
expectShape(const Image& image, const Colour& colour, Inside inside, double tolerance = 1e-3)
{
  int covered = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double depth = inside(x + 0.5, y + 0.5);
      if (std::abs(depth) < tolerance)
        continue;
      EXPECT_TRUE(isColour(at(image, x, y), depth > 0.0 ? colour : white)) << x << ' ' << y;
      covered += depth > 0.0 ? 1 : 0;
    }
  EXPECT_GT(covered, 0) << "there is something to be seen";
}

std::array<ShadedCorner, 3>
triangle(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, const Colour& colour)
{
  return {ShadedCorner{a, colour, 1.0F}, {b, colour, 1.0F}, {c, colour, 1.0F}};
}

/** Distance of (x, y) to the line from a to b, positive on its left in an image whose y points down. */
double
leftOf(const ScreenPoint& a, const ScreenPoint& b, double x, double y)
{
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return (dx * (y - a.y) - dy * (x - a.x)) / std::hypot(dx, dy);
}

TEST(Rasterizer, IsWhiteAtFirst)
{
  const Image image = Rasterizer(3, 2).reduce(1);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, std::vector<std::uint8_t>(18, 255));
}

TEST(Rasterizer, TriangleCoversTheCentresInside)
{
  const ScreenPoint a = {3.2F, 2.1F, 0.0F};
  const ScreenPoint b = {28.7F, 9.4F, 0.0F};
  const ScreenPoint c = {11.3F, 30.6F, 0.0F};
  const auto inside = [&](double x, double y) {
    return std::min({leftOf(a, b, x, y), leftOf(b, c, x, y), leftOf(c, a, x, y)});
  };
  for (const auto& corners : {triangle(a, b, c, red), triangle(a, c, b, red), triangle(c, a, b, red)}) {
    Rasterizer canvas(size, size);
    canvas.fillTriangle(corners);
    expectShape(canvas.reduce(1), red, inside);
  }
}

TEST(Rasterizer, DiscCoversTheCentresInside)
{
  Rasterizer canvas(size, size);
  canvas.fillDisc({12.3F, 17.9F, 0.0F}, 8.4F, blue);
  expectShape(canvas.reduce(1), blue, [](double x, double y) { return 8.4 - std::hypot(x - 12.3, y - 17.9); });
}

TEST(Rasterizer, SegmentHasRoundEnds)
{
  const auto inside = [](double ax, double ay, double bx, double by) {
    return [=](double x, double y) {
      const double squared = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
      const double along = squared > 0.0 ? ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / squared : 0.0;
      const double t = std::min(1.0, std::max(0.0, along));
      return 2.6 - std::hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
    };
  };
  // Slanted both ways, level, upright, a single place, and one that leaves the image.
  const std::vector<std::array<float, 4>> segments = {{5, 6, 25, 27},      {26, 4, 7, 20},      {4, 9.5F, 27, 9.5F},
                                                      {8.5F, 4, 8.5F, 28}, {15, 16, 15, 16},    {-20, 12, 60, 22},
                                                      {5, 5, 6, 25},       {20, 31, 10, -40.0F}};
  for (const auto& [ax, ay, bx, by] : segments) {
    SCOPED_TRACE(::testing::Message() << ax << ' ' << ay << ' ' << bx << ' ' << by);
    Rasterizer canvas(size, size);
    canvas.blendSegment({ax, ay, 0.0F}, {bx, by, 0.0F}, 2.6F, red, {1.0F, 0.0F});
    expectShape(canvas.reduce(1), red, inside(ax, ay, bx, by));
  }
}

TEST(Rasterizer, WhatIsNearerHidesTheRestInAnyOrder)
{
  for (const bool near_first : {true, false}) {
    Rasterizer canvas(size, size);
    for (const bool near : {near_first, !near_first})
      canvas.fillDisc({16.0F, 16.0F, near ? 2.0F : 1.0F}, 5.0F, near ? red : blue);
    EXPECT_EQ(at(canvas.reduce(1), 16, 16), red) << near_first;
  }
}

TEST(Rasterizer, DepthOfATriangleIsThatOfItsPlane)
{
  // Two crossing slopes: each is in front on one half.
  Rasterizer canvas(size, size);
  const auto slope = [&canvas](float left, float right, const Colour& colour) {
    canvas.fillTriangle(triangle({0, 0, left}, {size, 0, right}, {size, size, right}, colour));
    canvas.fillTriangle(triangle({0, 0, left}, {size, size, right}, {0, size, left}, colour));
  };
  slope(0.0F, 1.0F, red);
  slope(1.0F, 0.0F, blue);
  const Image image = canvas.reduce(1);
  for (int y = 0; y < size; ++y) {
    EXPECT_TRUE(isColour(at(image, size / 2 - 2, y), blue)) << y;
    EXPECT_TRUE(isColour(at(image, size / 2 + 1, y), red)) << y;
  }
}

TEST(Rasterizer, BrightnessIsSmoothAndColourThatOfTheNearestCorner)
{
  Rasterizer canvas(size, size);
  canvas.fillTriangle(
      {ShadedCorner{{0, 0, 0}, {200, 0, 0}, 1.0F}, {{64, 0, 0}, {0, 200, 0}, 0.0F}, {{0, 64, 0}, {0, 0, 200}, 1.0F}});
  const Image image = canvas.reduce(1);
  // Along the first row brightness falls by 1 on 64 pixels; the border of red and green is half way.
  for (int x = 0; x < 31; ++x) {
    const double expected = 200.0 * (1.0 - (x + 0.5) / 64.0);
    EXPECT_NEAR(at(image, x, 0)[0], expected, 1.0) << x;
    EXPECT_EQ(at(image, x, 0)[1], 0) << x;
  }
  EXPECT_TRUE(isColour(at(image, 0, 20), Colour{198, 0, 0})) << "of equal corners the place decides";
}

TEST(Rasterizer, LinesAreBlendedByTheirDepth)
{
  Rasterizer canvas(size, size);
  canvas.fillTriangle(triangle({0, 0, 1}, {2 * size, 0, 1}, {0, 2 * size, 1}, {100, 100, 100}));
  canvas.blendSegment({4, 8.5F, 2}, {28, 8.5F, 2}, 1.0F, {200, 200, 200}, {0.5F, 0.1F});
  canvas.blendSegment({4, 20.5F, 0}, {28, 20.5F, 0}, 1.0F, {200, 200, 200}, {0.5F, 0.1F});
  const Image before = canvas.reduce(1);
  EXPECT_TRUE(isColour(at(before, 16, 8), (Colour{150, 150, 150}))) << "in front";
  EXPECT_TRUE(isColour(at(before, 16, 20), (Colour{110, 110, 110}))) << "behind";
  canvas.fillDisc({16.5F, 8.5F, 1.5F}, 0.6F, red);
  EXPECT_EQ(at(canvas.reduce(1), 16, 8), red) << "a line leaves the depth as it was";
}

TEST(Rasterizer, ShapesThatAreNoneDrawNothing)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Rasterizer canvas(size, size);
  canvas.fillTriangle(triangle({1, 1, 0}, {10, 10, 0}, {20, 20, 0}, red));
  canvas.fillTriangle(triangle({1, nan, 0}, {10, 3, 0}, {3, 20, 0}, red));
  canvas.fillTriangle(triangle({1, infinity, 0}, {10, 3, 0}, {3, 20, 0}, red));
  canvas.fillDisc({nan, 10.0F, 0.0F}, 5.0F, red);
  canvas.fillDisc({-40.0F, 10.0F, 0.0F}, 5.0F, red);
  canvas.blendSegment({nan, 3, 0}, {20, 20, 0}, 2.0F, red, {1.0F, 1.0F});
  const Image image = canvas.reduce(1);
  EXPECT_EQ(image.pixels, Rasterizer(size, size).reduce(1).pixels);
}

TEST(Rasterizer, StopsWhereTheImageHasBeenDrawnOverManyTimes)
{
  Rasterizer canvas(size, size);
  const auto half = triangle({0, 0, 1}, {size, 0, 1}, {0, size, 1}, red);
  EXPECT_EQ(canvas.pixelsOf(half), size * size);
  EXPECT_TRUE(canvas.hasRoomFor(Rasterizer::pass_limit * canvas.pixelsOf(half)));
  EXPECT_FALSE(canvas.hasRoomFor(Rasterizer::pass_limit * canvas.pixelsOf(half) + 1.0));
  for (int i = 0; i < Rasterizer::pass_limit; ++i)
    canvas.fillTriangle(half);
  EXPECT_FALSE(canvas.hasRoomFor(1.0));
  const Image full = canvas.reduce(1);
  canvas.fillTriangle(triangle({0, 0, 2}, {size, 0, 2}, {0, size, 2}, blue));
  canvas.fillDisc({8, 8, 3}, 5.0F, blue);
  EXPECT_EQ(canvas.reduce(1).pixels, full.pixels);
  for (int i = 0; i < 2 * Rasterizer::pass_limit; ++i)
    canvas.blendSegment({0, 16, 5}, {size, 16, 5}, size, black, {1.0F, 1.0F});
  const Image blended = canvas.reduce(1);
  EXPECT_NE(blended.pixels, full.pixels);
  canvas.blendSegment({0, 16, 6}, {size, 16, 6}, 3.0F, white, {1.0F, 1.0F});
  EXPECT_EQ(canvas.reduce(1).pixels, blended.pixels);
}

TEST(Rasterizer, ReduceAveragesSquares)
{
  Rasterizer canvas(4, 4);
  canvas.fillDisc({0.5F, 0.5F, 0.0F}, 0.6F, black);
  canvas.fillDisc({3.5F, 3.5F, 0.0F}, 0.6F, {55, 155, 255});
  const Image image = canvas.reduce(2);
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(at(image, 0, 0), (Colour{191, 191, 191})); // three of four are white
  EXPECT_TRUE(isColour(at(image, 1, 0), white));
  EXPECT_EQ(at(image, 1, 1), (Colour{205, 230, 255}));
}

TEST(Shade, ScalesTheChannelsWithinTheirRange)
{
  EXPECT_EQ(shade({200, 100, 50}, 0.5F), (Colour{100, 50, 25}));
  EXPECT_EQ(shade({200, 100, 50}, 1.0F), (Colour{200, 100, 50}));
  EXPECT_EQ(shade({200, 100, 50}, 7.0F), (Colour{200, 100, 50}));
  EXPECT_EQ(shade({200, 100, 50}, -1.0F), black);
}

} // namespace
