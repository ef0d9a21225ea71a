#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadPcd = TemporaryFolder;

const std::string xyz_header = "# .PCD v.7\nVERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

/** \brief An organised cloud with a hole, as a depth camera delivers it. */
PointCloud<PointXYZRGBNormal>
organisedCloud()
{
  PointCloud<PointXYZRGBNormal> cloud(5, 4);
  cloud.is_dense = false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].x = 0.1F * static_cast<float>(i);
    cloud[i].y = -1.0F / static_cast<float>(i + 1);
    cloud[i].z = static_cast<float>(i % 5);
    cloud[i].rgba = 0xFF102030U + static_cast<std::uint32_t>(i);
    cloud[i].normal_x = 0.0F;
    cloud[i].normal_y = 0.6F;
    cloud[i].normal_z = 0.8F;
  }
  cloud[7].x = cloud[7].y = cloud[7].z = std::numeric_limits<float>::quiet_NaN();
  return cloud;
}

void
expectEqual(const Surface& surface, const PointCloud<PointXYZRGBNormal>& cloud)
{
  ASSERT_EQ(surface.size(), cloud.size());
  ASSERT_EQ(surface.normals.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i == 7)
      EXPECT_TRUE(std::isnan(surface.points[i][0]) && std::isnan(surface.points[i][2]));
    else
      EXPECT_EQ(surface.points[i], (Vector3{cloud[i].x, cloud[i].y, cloud[i].z}));
    EXPECT_EQ(surface.normals[i], (Vector3{0.0F, 0.6F, 0.8F}));
  }
}

TEST_F(ReadPcd, WhatPclWritesInAllThreeKinds)
{
  const PointCloud<PointXYZRGBNormal> cloud = organisedCloud();
  ASSERT_EQ(io::savePCDFileASCII(path("ascii.pcd"), cloud), 0);
  ASSERT_EQ(io::savePCDFileBinary(path("binary.pcd"), cloud), 0);
  ASSERT_EQ(io::savePCDFileBinaryCompressed(path("compressed.PCD"), cloud), 0);
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.PCD"}) {
    SCOPED_TRACE(name);
    expectEqual(readSurface(path(name)), cloud);
  }
}

TEST_F(ReadPcd, FieldsOfOtherTypesAndOrder)
{
  Bytes bytes;
  for (int i = 0; i < 2; ++i)
    bytes.add(std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, 0.1 + i, std::int16_t{-7}, std::uint8_t{200});
  const Surface surface =
      readSurface(write("mixed.pcd", "VERSION .7\nFIELDS _ z x y\nSIZE 1 8 2 1\nTYPE U F I U\nCOUNT 3 1 1 1\n"
                                     "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA binary\n" +
                                         bytes.str()));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{-7.0F, 200.0F, 0.1F}, {-7.0F, 200.0F, 1.1F}}));
  EXPECT_TRUE(surface.normals.empty());
}

TEST_F(ReadPcd, HeaderOfOlderWriters)
{
  const Surface surface = readSurface(write(
      "old.pcd", "VERSION .6\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA ascii\n1 2 3\n\n# note\n4 5 6\n"));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}}));
}

TEST_F(ReadPcd, DecimalNumbersRoundToTheNearestFloat)
{
  const Surface surface = readSurface(
      write("exact.pcd", xyz_header + "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n0.1 16777217 1.00000017881393432\n"));
  EXPECT_EQ(surface.points[0], (Vector3{0.1F, 16777216.0F, 1.00000017881393432F}));
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
