#include "support/prepared.h"
#include "symmetry/confidence/unsupported_parts.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr int columns = 21;
constexpr int rows = 11;

/** Marks the points of a grid in some of its columns. */
std::vector<char>
marked(int first, int last)
{
  std::vector<char> marks;
  for (int i = 0; i < columns * rows; ++i) {
    marks.push_back(i % columns >= first && i % columns <= last ? 1 : 0);
  }
  return marks;
}

TEST(UnsupportedParts, AreToldApartTheLargestFirst)
{
  const PreparedSurface surface = prepared(gridMesh(columns, rows));
  std::vector<char> marks = marked(0, 2);
  const std::vector<char> others = marked(15, 20);
  for (std::size_t v = 0; v < marks.size(); ++v) {
    marks[v] = marks[v] != 0 || others[v] != 0 ? 1 : 0;
  }
  const std::vector<UnsupportedPart> parts = unsupportedParts(surface, marks);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, 6U * rows);
  EXPECT_EQ(parts[1].points, 3U * rows);
  EXPECT_NEAR(parts[0].share, 5.5F / 20.0F, 1e-4F) << "points at the border stand for half of an area";
  EXPECT_NEAR(parts[1].share, 2.5F / 20.0F, 1e-4F);
  EXPECT_NEAR(parts[0].extent, 6.0F, 1e-3F) << "from the last supported column to the border";
  EXPECT_EQ(parts[0].extreme % columns, columns - 1);
  EXPECT_TRUE(unsupportedParts(surface, marked(1, 0)).empty());
}

TEST(DropSmallParts, TakesTheMarkOffSmallOnes)
{
  const PreparedSurface surface = prepared(gridMesh(columns, rows));
  std::vector<char> marks = marked(0, 2); // an eighth of the area
  const std::vector<char> large = marked(15, 20);
  for (std::size_t v = 0; v < marks.size(); ++v) {
    marks[v] = marks[v] != 0 || large[v] != 0 ? 1 : 0;
  }
  const std::vector<char> both = marks;
  dropSmallParts(surface, 0.12F, marks);
  EXPECT_EQ(marks, both);
  dropSmallParts(surface, 0.13F, marks);
  EXPECT_EQ(marks, large);
  dropSmallParts(surface, 0.5F, marks);
  EXPECT_EQ(marks, marked(1, 0));
}

TEST(ShareWithPartner, IsOfTheAreaWhereThereAreTriangles)
{
  const Surface grid = gridMesh(columns, rows);
  std::vector<Index> partners(grid.size(), no_index);
  for (std::size_t v = 0; v < partners.size(); ++v) {
    partners[v] = marked(0, 2)[v] != 0 ? 0 : no_index;
  }
  EXPECT_NEAR(shareWithPartner(prepared(grid), partners), 2.5F / 20.0F, 1e-4F);
  PreparedSurface cloud = prepared(grid);
  cloud.triangles.clear();
  EXPECT_NEAR(shareWithPartner(cloud, partners), 3.0F / columns, 1e-4F);
}

} // namespace
