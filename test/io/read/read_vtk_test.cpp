#include "support/bytes.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/io/vtk_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadVtk = TemporaryFolder;

const std::string head = "# vtk DataFile Version 3.0\nby hand\n";
const std::string five_points = "POINTS 5 float\n0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 1\n";
const std::vector<Triangle> roof_faces = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}};

TEST_F(ReadVtk, PolygonsAndStripsOfALegacyFile)
{
  const Surface polygons = readSurface(
      write("a.VTK", head + "ASCII\nDATASET POLYDATA\n" + five_points + "POLYGONS 2 9\n4 0 1 2 3\n3 3 2 4\n"));
  EXPECT_EQ(polygons.size(), 5U);
  EXPECT_EQ(polygons.points[4], (Vector3{0.5F, 0.5F, 1.0F}));
  EXPECT_EQ(polygons.triangles, roof_faces);
  const Surface strip = readSurface(
      write("b.vtk", head + "ASCII\nDATASET POLYDATA\n" + five_points + "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\n"));
  EXPECT_EQ(strip.triangles, (std::vector<Triangle>{{0, 1, 3}, {3, 1, 2}}));
}

TEST_F(ReadVtk, ACloudHasNoFaces)
{
  const Surface cloud = readSurface(
      write("a.vtk", head + "ASCII\nDATASET POLYDATA\n" + five_points + "VERTICES 5 10\n1 0\n1 1\n1 2\n1 3\n1 4\n"));
  EXPECT_EQ(cloud.size(), 5U);
  EXPECT_FALSE(cloud.hasFaces());
  EXPECT_TRUE(cloud.notes.empty());
}

TEST_F(ReadVtk, BinaryIsBigEndian)
{
  const std::string points = Bytes(true).add(0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F).str();
  const Surface surface =
      readSurface(write("a.vtk", head + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + points + "\nPOLYGONS 1 4\n" +
                                     Bytes(true).add(3, 0, 1, 2).str() + "\n"));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(ReadVtk, CellsThatArePolygonsOfAGrid)
{
  const Surface surface = readSurface(
      write("a.vtk", head + "ASCII\nDATASET UNSTRUCTURED_GRID\n" + five_points +
                         "CELLS 3 14\n4 0 1 3 2\n3 3 2 4\n4 0 1 2 4\nCELL_TYPES 3\n8\n5\n10\n")); // pixel, tetrahedron
  EXPECT_EQ(surface.triangles, roof_faces);
  ASSERT_EQ(surface.notes.size(), 1U);
  EXPECT_EQ(surface.notes[0], "1 cells that are no polygons were passed over");
}

/** From version 5 on where lists begin stands apart from their corners. */
TEST_F(ReadVtk, OffsetsAndCornersApart)
{
  const std::string newer =
      "# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\n" + five_points + "METADATA\nINFORMATION 0\n\n";
  const Surface text = readSurface(write("a.vtk", newer + "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7\n"
                                                          "CONNECTIVITY vtktypeint64\n0 1 2 3 3 2 4\n"));
  EXPECT_EQ(text.triangles, roof_faces);
  const std::string points = Bytes(true).add(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0).str();
  const Surface binary = readSurface(
      write("b.vtk", "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n" + points +
                         "\nCELLS 2 3\nOFFSETS vtktypeint64\n" +
                         Bytes(true).add(std::int64_t{0}, std::int64_t{3}).str() + "\nCONNECTIVITY vtktypeint64\n" +
                         Bytes(true).add(std::int64_t{2}, std::int64_t{0}, std::int64_t{1}).str() + "\nCELL_TYPES 1\n" +
                         Bytes(true).add(5).str() + "\n"));
  EXPECT_EQ(binary.points[1], (Vector3{1, 0, 0}));
  EXPECT_EQ(binary.triangles, (std::vector<Triangle>{{2, 0, 1}}));
}

TEST_F(ReadVtk, WhatBoundsNoAreaAndPointDataArePassedOver)
{
  const Surface surface = readSurface(
      write("a.vtk", head + "ASCII\nDATASET POLYDATA\n" + five_points + "LINES 1 3\n2 0 1\nPOLYGONS 1 4\n3 0 1 2\n" +
                         "POINT_DATA 5\nSCALARS polygons int 1\nLOOKUP_TABLE default\n1 2 3 4 5\n"));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(ReadVtk, FieldsOfTheWholeArePassedOver)
{
  const std::string field = "FIELD FieldData 1\nTIME 2 1 double\n";
  EXPECT_EQ(readSurface(write("a.vtk", head + "ASCII\nDATASET POLYDATA\n" + field + "0.5\n1\n" + five_points)).size(),
            5U);
  EXPECT_EQ(readSurface(write("b.vtk", head + "BINARY\nDATASET POLYDATA\n" + field + Bytes(true).add(0.5, 1.0).str() +
                                           "\nPOINTS 1 float\n" + Bytes(true).add(1.0F, 2.0F, 3.0F).str() + "\n"))
                .points[0],
            (Vector3{1, 2, 3}));
}

TEST_F(ReadVtk, FilesThatPclWrites)
{
  PolygonMesh mesh;
  PointCloud<PointXYZ> cloud;
  for (const Vector3& p : {Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 0.25F, 0}})
    cloud.push_back(PointXYZ(p[0], p[1], p[2]));
  toPCLPointCloud2(cloud, mesh.cloud);
  mesh.polygons.resize(1);
  mesh.polygons[0].vertices = {2, 0, 1};
  ASSERT_EQ(io::saveVTKFile(path("a.vtk"), mesh), 0);
  const Surface surface = readSurface(path("a.vtk"));
  EXPECT_EQ(surface.points[2], (Vector3{0, 0.25F, 0}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{2, 0, 1}}));
}

TEST_F(ReadVtk, TruncatedFilesAreRefusedWhateverIsLeft)
{
  const std::string content = head + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n" +
                              Bytes(true).add(0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F).str() +
                              "\nPOLYGONS 1 4\n" + Bytes(true).add(3, 0, 1, 2).str();
  const std::size_t faces = content.find("POLYGONS");
  EXPECT_TRUE(readSurface(write("a.vtk", content)).hasFaces());
  for (std::size_t size = 0; size < content.size(); ++size) {
    if (size != faces - 1 && size != faces) { // a cloud, whole without its faces
      EXPECT_THROW(readSurface(write("a.vtk", content.substr(0, size))), IOException) << size;
    }
  }
}

TEST_F(ReadVtk, RefusesWhatIsNone)
{
  const std::string polygons = head + "ASCII\nDATASET POLYDATA\n" + five_points;
  const std::string grid = head + "ASCII\nDATASET UNSTRUCTURED_GRID\n" + five_points;
  const std::string newer_polygons =
      "# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\n" + five_points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n";
  const std::vector<std::pair<std::string, std::vector<std::string>>> broken = {
      {"# vtk DataFil\n", {"line 1", "not a VTK file"}},
      {head + "TEXT\nDATASET POLYDATA\n", {"line 3", "'text'", "'ASCII' nor 'BINARY'"}},
      {head + "ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\n", {"line 4", "'structured_points'"}},
      {head + "ASCII\nDATASET POLYDATA\nPOINTS 2000000000 float\n0 0 0\n", {"line 5", "too short", "6000000000"}},
      {head + "ASCII\nDATASET POLYDATA\nPOINTS 5 half\n0 0 0\n", {"line 5", "'half'"}},
      {head + "ASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 0 0 0 0 0 0 0 0 0 0 0\n", {"file ends", "a number"}},
      {head + "ASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 0 b 0\n", {"line 6", "'b'", "not a number"}},
      {polygons + "POLYGONS 1 4\n3 0 1 5\n", {"point 5 of 5"}},
      {polygons + "POLYGONS 1 4\n4 0 1 2\n", {"list 0", "beyond"}},
      {polygons + "POLYGONS 2 4\n3 0 1 2\n", {"list 1", "beyond"}},
      {polygons + "POLYGONS 1 4\n-3 0 1 2\n", {"list 0", "beyond"}},
      {polygons + five_points, {"second list of points"}},
      {polygons + "POLYGON 1 4\n3 0 1 2\n", {"unknown section 'polygon'"}},
      {grid + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n", {"2 types of cells"}},
      {grid + "CELLS 1 4\n3 0 1 2\n", {"0 types of cells"}},
      {newer_polygons + "0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n", {"offset 4 among 3 corners"}},
      {newer_polygons + "-1 3\nCONNECTIVITY vtktypeint64\n0 1 2\n", {"offset -1 among 3 corners"}},
      {newer_polygons + "3 0\nCONNECTIVITY vtktypeint64\n0 1 2\n", {"offset 0 among 3 corners"}},
      {newer_polygons + "0 3\nCORNERS vtktypeint64\n0 1 2\n", {"'CONNECTIVITY' is expected"}},
      {newer_polygons + "0 3\nCONNECTIVITY float\n0 1 2\n", {"no integers"}},
      {head + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + std::string(35, '\0'), {"file ends within 9 numbers"}}};
  for (const auto& [content, words] : broken) {
    SCOPED_TRACE(content);
    expectInMessage(messageOf<IOException>([&, content = content] { readSurface(write("a.vtk", content)); }), words);
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
