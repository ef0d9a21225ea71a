// Positions at map coordinates: what is subtracted, that nothing is lost by it, and that it is added again when written.
#include "base/map_offset.h"
#include "io/sample_result.h"
#include "support/bytes.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using MapOffset = TemporaryFolder;
using Position = std::array<double, 3>;

const Position place = {2801234.5678, 5401240.25, 103.125};

/** \brief roof() in double precision at its place on a map. */
std::vector<Position>
farRoof()
{
  std::vector<Position> positions;
  for (const Vector3& p : roof().points)
    positions.push_back({place[0] + double{p[0]}, place[1] + double{p[1]}, place[2] + double{p[2]}});
  return positions;
}

std::string
digits(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

/** \brief farRoof() in all formats that hold doubles or text; OFF and OBJ with faces. */
std::vector<std::pair<std::string, std::string>>
farFiles()
{
  std::string off = "OFF\n6 4 0\n";
  std::string obj;
  std::string pcd;
  Bytes binary;
  for (const Position& p : farRoof()) {
    const std::string line = digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
    off += line;
    obj += "v " + line;
    pcd += line;
    binary.add(p);
  }
  std::string stl = "solid roof\n";
  for (const Triangle& t : roof().triangles) {
    off += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    stl += "facet normal 0 0 1\nouter loop\n";
    for (const Index corner : t) {
      const Position p = farRoof()[static_cast<std::size_t>(corner)];
      stl += "vertex " + digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
    }
    stl += "endloop\nendfacet\n";
  }
  const std::string pcd_header = "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 6\nDATA ";
  const std::string ply_header = "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty double x\n"
                                 "property double y\nproperty double z\nend_header\n";
  return {{"far.off", off},
          {"far.obj", obj},
          {"text.pcd", pcd_header + "ascii\n" + pcd},
          {"binary.pcd", pcd_header + "binary\n" + binary.str()},
          {"far.ply", ply_header + binary.str()},
          {"far.stl", stl + "endsolid\n"}};
}

TEST_F(MapOffset, IsSubtractedInDoublePrecisionInEveryFormat)
{
  for (const auto& [name, content] : farFiles()) {
    SCOPED_TRACE(name);
    const Surface surface = readSurface(write(name, content));
    ASSERT_EQ(surface.size(), 6U);
    const bool renumbered = name == "far.stl"; // in the order of the facets
    const std::size_t order[] = {0, 2, 3, 1, 4, 5};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(double{surface.points[i][k]} + surface.offset[k], farRoof()[renumbered ? order[i] : i][k], 1e-6);
    for (const Vector3& p : surface.points)
      EXPECT_LT(std::abs(p[0]) + std::abs(p[1]), 20.0F);
  }
}

TEST_F(MapOffset, IsAddedAgainByTheWriters)
{
  const Surface surface = readSurface(write("far.off", farFiles()[0].second));
  for (const char* name : {"again.ply", "again.pcd"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path(name), surface, roofSymmetry());
    const Surface again = readSurface(path(name));
    EXPECT_EQ(again.offset, surface.offset);
    EXPECT_EQ(again.points, surface.points);
    SymmetryResult result = roofSymmetry();
    result.axis = {lineThrough(surface, {2, 3}, false)};
    writeAxis(path(name), surface, result);
    const Surface axis = readSurface(path(name));
    ASSERT_EQ(axis.size(), 2U);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(double{axis.points[0][k]} + axis.offset[k], farRoof()[2][k], 1e-6);
  }
}

TEST_F(MapOffset, PclLoadsWhatIsWrittenAsDoubles)
{
  const Surface surface = readSurface(write("far.off", farFiles()[0].second));
  writeLabelledSurface(path("a.pcd"), surface, roofSymmetry());
  writeLabelledSurface(path("a.ply"), surface, roofSymmetry());
  PCLPointCloud2 clouds[2];
  ASSERT_EQ(io::loadPCDFile(path("a.pcd"), clouds[0]), 0);
  ASSERT_EQ(io::loadPLYFile(path("a.ply"), clouds[1]), 0);
  for (const PCLPointCloud2& cloud : clouds) {
    ASSERT_EQ(cloud.fields.at(1).name, "y");
    ASSERT_EQ(cloud.fields[1].datatype, PCLPointField::FLOAT64);
    double y = 0.0;
    std::memcpy(&y, cloud.data.data() + 3 * cloud.point_step + cloud.fields[1].offset, sizeof(y));
    EXPECT_NEAR(y, farRoof()[3][1], 1e-6);
  }
}

TEST_F(MapOffset, NothingMovesNearTheOrigin)
{
  const Surface surface = readSurface(write("near.off", "OFF\n3 1 0\n100 0 0\n101 0 0\n100 1 0\n3 0 1 2\n"));
  EXPECT_EQ(surface.offset, Position());
  EXPECT_EQ(surface.points[1], (Vector3{101.0F, 0.0F, 0.0F}));
  const Surface one = readSurface(write("one.off", "OFF\n2 0 0\n4000000 0 0\n4000000 0 0\n"));
  EXPECT_EQ(one.offset, Position()) << "points all at one place have no extent to be told apart in";
}

TEST_F(MapOffset, IntegersInATextAreExact)
{
  const std::string faces = "3 0 1 2\n";
  const Surface surface =
      readSurface(write("far.off", "OFF\n3 1 0\n500000 4500000 0\n500001 4500000 0\n500000 4500001 0\n" + faces));
  EXPECT_EQ(surface.points[2][1] - surface.points[0][1], 1.0F);
}

TEST_F(MapOffset, StrayPointsDoNotCount)
{
  std::vector<Vector3> points(1000, Vector3{4e6F, 4e6F, 100.0F});
  std::mt19937 random(1);
  for (Vector3& p : points)
    for (float& coordinate : p)
      coordinate += static_cast<float>(random() % 64U);
  for (std::size_t i = 0; i < points.size(); i += 40)
    points[i] = {0.0F, 0.0F, 0.0F}; // what a scanner did not see
  points[7] = {NAN, 0.0F, 0.0F};
  const Position offset = findOffset(points);
  EXPECT_NEAR(offset[0], 4e6, 100.0);
  EXPECT_NEAR(offset[1], 4e6, 100.0);
  EXPECT_NEAR(offset[2], 100.0, 64.0) << "along with the others";
}

TEST_F(MapOffset, FloatsAreMovedAndMovedBackExactly)
{
  std::mt19937 random(2);
  for (const float distance : {3e4F, 1e6F, 7e7F}) {
    std::vector<Vector3> points(300);
    for (Vector3& p : points)
      for (float& coordinate : p)
        coordinate = distance + static_cast<float>(random() % 1000U) * 0.01F * distance / 3e4F;
    const Position offset = findOffset(points);
    EXPECT_NE(offset[0], 0.0);
    for (const Vector3& p : points) {
      const auto moved = static_cast<float>(double{p[0]} - offset[0]);
      EXPECT_EQ(double{moved} + offset[0], double{p[0]});
    }
  }
}

TEST_F(MapOffset, FloatsThatHaveLostTheShapeAreRefused)
{
  Bytes bytes;
  for (const Position& p : farRoof())
    bytes.add(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
  const std::string file =
      write("float.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty float x\n"
                         "property float y\nproperty float z\nend_header\n" +
                             bytes.str());
  const std::string message = messageOf<IOException>([&] { readSurface(file); });
  EXPECT_NE(message.find("as floats, too far from the origin"), std::string::npos) << message;
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
