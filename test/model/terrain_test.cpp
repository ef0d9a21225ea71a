#include "base/vector_math.h"
#include "model/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

using namespace pcl::symmetry;

namespace {

Surface
terrain(std::size_t vertices, std::uint64_t seed)
{
  RandomNumbers random(seed);
  return makeTerrain(vertices, random);
}

TEST(Terrain, HasAboutAsManyVerticesAsAskedFor)
{
  for (const std::size_t wanted : {100U, 1000U, 5000U}) {
    const auto found = static_cast<double>(terrain(wanted, 1).size());
    EXPECT_NEAR(found, static_cast<double>(wanted), 0.05 * static_cast<double>(wanted));
  }
}

TEST(Terrain, IsOneSheetWithOneBorder)
{
  const Surface sheet = terrain(400, 2);
  std::map<std::pair<Index, Index>, int> sides;
  for (const Triangle& t : sheet.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  const auto border = std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second == 1; });
  EXPECT_EQ(border, 4 * 19); // of 20 x 20 vertices
  EXPECT_TRUE(std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second <= 2; }));
  EXPECT_EQ(sheet.size() + sheet.triangles.size(), sides.size() + 1); // Euler: one disc
}

TEST(Terrain, FacesUpwards)
{
  const Surface sheet = terrain(900, 3);
  for (const Triangle& t : sheet.triangles) {
    const Vector3& a = sheet.points[t[0]];
    EXPECT_GT(cross(sheet.points[t[1]] - a, sheet.points[t[2]] - a)[1], 0.0F); // y points up
  }
}

TEST(Terrain, FollowsFromTheSeedAlone)
{
  EXPECT_EQ(terrain(300, 4).points, terrain(300, 4).points);
  EXPECT_NE(terrain(300, 4).points, terrain(300, 5).points);
}

} // namespace
