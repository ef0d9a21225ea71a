#include "support/bytes.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
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

TEST_F(ReadPcd, NamesInCapitalsAndSmallTypes)
{
  const std::string rest = "SIZE 4 4 4\nTYPE f f f\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n";
  const std::vector<Vector3> expected = {{1.0F, 2.0F, 3.0F}};
  EXPECT_EQ(readSurface(write("upper.pcd", "VERSION .7\nFIELDS X Y Z\n" + rest)).points, expected);
  EXPECT_THROW(readSurface(write("both.pcd", "VERSION .7\nFIELDS X x y\n" + rest)), IOException) << "no z";
}

TEST_F(ReadPcd, AFieldOfNoValues)
{
  const std::string text = "VERSION .7\nFIELDS _ x none y z\nSIZE 1 4 2 4 4\nTYPE U F U F F\nCOUNT 3 1 0 1 1\n"
                           "WIDTH 2\nHEIGHT 1\nPOINTS 2\n";
  const std::vector<Vector3> expected = {{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}};
  EXPECT_EQ(readSurface(write("ascii.pcd", text + "DATA ascii\n0 0 0 1 2 3\n0 0 0 4 5 6\n")).points, expected);
  Bytes bytes;
  for (const Vector3& point : expected)
    bytes.add(std::uint8_t{9}, std::uint16_t{9}, point);
  EXPECT_EQ(readSurface(write("binary.pcd", text + "DATA binary\n" + bytes.str())).points, expected);
}

TEST_F(ReadPcd, NoNumberInAnyCase)
{
  const Surface surface = readSurface(
      write("nan.pcd", xyz_header + "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\nnan NaN NAN\n-nan Inf -INFINITY\n"));
  for (const float coordinate : surface.points[0])
    EXPECT_TRUE(std::isnan(coordinate));
  EXPECT_TRUE(std::isnan(surface.points[1][0]));
  EXPECT_EQ(surface.points[1][1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(surface.points[1][2], -std::numeric_limits<float>::infinity());
}

/** \brief Points all alike in three fields of a byte, compressed as far as the format allows. */
std::string
compressedBomb(std::size_t points)
{
  const std::size_t bytes = 3 * points;
  std::string packed = std::string(1, '\0') + 'x'; // one literal byte
  std::size_t unpacked = 1;
  for (; unpacked + 264 <= bytes; unpacked += 264)
    packed += std::string("\xE0\xFF\x00", 3); // repeat the last byte 264 times
  for (; unpacked < bytes; ++unpacked)
    packed += std::string("\0x", 2);
  return "FIELDS x y z\nSIZE 1 1 1\nTYPE U U U\nWIDTH " + std::to_string(points) + "\nDATA binary_compressed\n" +
         Bytes().add(static_cast<std::uint32_t>(packed.size()), static_cast<std::uint32_t>(bytes)).str() + packed;
}

TEST_F(ReadPcd, ASmallCompressedFileCannotBecomeHuge)
{
  EXPECT_EQ(readSurface(write("large.pcd", compressedBomb(100000))).size(), 100000U);
  const std::string file = write("bomb.pcd", compressedBomb(27000000));
  const std::string message = messageOf<IOException>([&] { readSurface(file); });
  EXPECT_NE(message.find("27000000 points"), std::string::npos) << message;
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
