// Polygons and strips as triangles, and counts against what a file can hold.
#include "io/read/surface_builder.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;

namespace {

using Triangles = std::vector<Triangle>;

Triangles
polygon(const std::vector<Index>& corners)
{
  Triangles triangles;
  appendPolygon(corners, triangles);
  return triangles;
}

Triangles
strip(const std::vector<Index>& corners)
{
  Triangles triangles;
  appendStrip(corners, triangles);
  return triangles;
}

TEST(SurfaceBuilder, PolygonsAreFansAroundTheirFirstCorner)
{
  EXPECT_EQ(polygon({7, 8, 9}), (Triangles{{7, 8, 9}}));
  EXPECT_EQ(polygon({4, 5, 6, 7, 8}), (Triangles{{4, 5, 6}, {4, 6, 7}, {4, 7, 8}}));
  for (const std::vector<Index>& few : {std::vector<Index>{}, {1}, {1, 2}})
    EXPECT_TRUE(polygon(few).empty());
  EXPECT_EQ(polygon({1, 2, 2, 3}), (Triangles{{1, 2, 3}})) << "without triangles that have no area";
  EXPECT_TRUE(polygon({1, 2, 1}).empty());
}

TEST(SurfaceBuilder, StripsKeepTheirOrientation)
{
  const Triangles triangles = strip({0, 1, 2, 3, 4});
  EXPECT_EQ(triangles, (Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  // Property: neighbours run through their common edge in opposite directions.
  for (std::size_t t = 1; t < triangles.size(); ++t) {
    int opposite = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        opposite +=
            triangles[t][i] == triangles[t - 1][(j + 1) % 3] && triangles[t][(i + 1) % 3] == triangles[t - 1][j];
    EXPECT_EQ(opposite, 1) << t;
  }
}

TEST(SurfaceBuilder, StripsEndAtMinusOne)
{
  EXPECT_EQ(strip({0, 1, 2, 3, no_index, 4, 5, 6}), (Triangles{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}}));
  EXPECT_TRUE(strip({no_index, 0, 1, no_index, no_index, 2, 3}).empty());
  EXPECT_EQ(strip({0, 1, 1, 2, 3}), (Triangles{{1, 2, 3}})) << "what has no area keeps the count going";
}

TEST(SurfaceBuilder, CountsAreComparedWithoutOverflow)
{
  EXPECT_TRUE(fitsInto(3, 4, 12));
  EXPECT_FALSE(fitsInto(4, 4, 15));
  EXPECT_TRUE(fitsInto(0, 4, 0));
  EXPECT_TRUE(fitsInto(1000, 0, 0)) << "records of no bytes take no room";
  EXPECT_FALSE(fitsInto(std::numeric_limits<std::uint64_t>::max(), 16, 64));
}

} // namespace
