#include "io/read/column_names.h"

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace {

TEST(ColumnNames, NameWhatTheyFit)
{
  const ColumnNames names("Intensity z X y", ' ', 4);
  EXPECT_TRUE(names.isNamed());
  EXPECT_EQ(names.size(), 4U);
  EXPECT_EQ(names.axisOf(0), 3U);
  EXPECT_EQ(names.axisOf(1), 2U);
  EXPECT_EQ(names.axisOf(2), 0U);
  EXPECT_EQ(names.axisOf(3), 1U);
}

TEST(ColumnNames, OfOtherNumberOrWithoutAPositionNameNothing)
{
  for (const ColumnNames& names : {ColumnNames("x y z", ' ', 4), ColumnNames("x y w a", ' ', 4),
                                   ColumnNames("", ' ', 4), ColumnNames("x;y;z", ' ', 4)}) {
    EXPECT_FALSE(names.isNamed());
    EXPECT_EQ(names.axisOf(0), 0U);
    EXPECT_EQ(names.axisOf(2), 2U);
    EXPECT_EQ(names.axisOf(3), 3U);
  }
}

TEST(ColumnNames, LeaveNormalsOutOfTheFields)
{
  Surface surface;
  surface.points.resize(2);
  ColumnNames("x y z nx ny nz w", ' ', 7).deliver({0, 0, 2, 5, 0, 3, 0, 6}, surface); // of any length where named
  EXPECT_EQ(surface.normals, (std::vector<Vector3>{{0, 0, 2}, {0, 3, 0}}));
  ASSERT_NE(surface.fields, nullptr);
  ASSERT_EQ(surface.fields->fields.size(), 1U);
  EXPECT_EQ(surface.fields->fields[0].name, "w");
}

} // namespace
} // namespace symmetry
} // namespace pcl
