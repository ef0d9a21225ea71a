#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadPly = TemporaryFolder;

const std::string float_vertices = "property float x\nproperty float y\nproperty float z\n";

std::string
header(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\ncomment a comment with format and element\nobj_info also\n" + elements +
         "end_header\n";
}

TEST_F(ReadPly, AsciiMeshWithQuad)
{
  const Surface surface =
      readSurface(write("quad.ply", header("ascii", "element vertex 4\n" + float_vertices +
                                                        "element face 1\nproperty list uchar int vertex_indices\n") +
                                        "0 0 0\n1 0 0\n1 1 0.5\n0 1 -2e-1\n4 0 1 2 3\n"));
  ASSERT_EQ(surface.size(), 4U);
  EXPECT_EQ(surface.points[2], (Vector3{1.0F, 1.0F, 0.5F}));
  EXPECT_EQ(surface.points[3], (Vector3{0.0F, 1.0F, -0.2F}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(surface.normals.empty());
}

TEST_F(ReadPly, AnyLetterCaseOfTheEndingAndAnyLineEnd)
{
  std::string text = header("ascii", "element vertex 1\n" + float_vertices) + "1 2 3";
  for (const char* name : {"UPPER.PLY", "Mixed.Ply"})
    EXPECT_EQ(readSurface(write(name, text)).points.at(0), (Vector3{1.0F, 2.0F, 3.0F}));
  for (const char* line_end : {"\r\n", "\r"}) {
    std::string converted;
    for (const char c : text)
      converted += c == '\n' ? line_end : std::string(1, c);
    EXPECT_EQ(readSurface(write("dos.ply", converted)).points.at(0), (Vector3{1.0F, 2.0F, 3.0F}));
  }
}

TEST_F(ReadPly, BinaryOfBothByteOrdersWithDoublesAndExtraProperties)
{
  for (const bool big_endian : {false, true}) {
    Bytes bytes(big_endian);
    const double third = 1.0 / 3.0;
    for (int i = 0; i < 3; ++i)
      bytes.add(std::uint8_t{7}, third + i, -2.5, std::int16_t{-3}, 0.0F, 0.6F, 0.8F);
    bytes.add(std::uint16_t{2}, 1.0, 2.0); // an element to pass over
    bytes.add(std::uint8_t{9}, std::uint32_t{3}, std::uint16_t{2}, std::uint16_t{1}, std::uint16_t{0}); // face
    const Surface surface = readSurface(write(
        "data.ply",
        header(big_endian ? "binary_big_endian" : "binary_little_endian",
               "element vertex 3\nproperty uchar quality\nproperty double x\nproperty float64 y\nproperty int16 z\n"
               "property float nx\nproperty float32 ny\nproperty float nz\n"
               "element extra 1\nproperty list ushort double values\n"
               "element face 1\nproperty uint8 flags\nproperty list uint ushort vertex_index\n") +
            bytes.str()));
    ASSERT_EQ(surface.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(surface.points[i],
                (Vector3{static_cast<float>(third + static_cast<double>(i)), -2.5F, -3.0F})); // exact to the float
      EXPECT_EQ(surface.normals.at(i), (Vector3{0.0F, 0.6F, 0.8F}));
    }
    EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{2, 1, 0}}));
  }
}

TEST_F(ReadPly, ListsWithinTheVertices)
{
  Bytes bytes;
  bytes.add(1.0F, std::uint8_t{2}, 5, 6, 2.0F, 3.0F).add(4.0F, std::uint8_t{0}, 5.0F, 6.0F);
  const Surface surface = readSurface(write(
      "list.ply", header("binary_little_endian", "element vertex 2\nproperty float x\nproperty list uchar int links\n"
                                                 "property float y\nproperty float z\n") +
                      bytes.str()));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}}));
}

TEST_F(ReadPly, TriangleStripsKeepTheirOrientation)
{
  const Surface surface = readSurface(
      write("strips.ply", header("ascii", "element vertex 5\n" + float_vertices +
                                              "element tristrips 1\nproperty list int int vertex_indices\n") +
                              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 4 3 2\n"));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 2}}));
}

TEST_F(ReadPly, DegenerateFacesAreLeftOut)
{
  const Surface surface = readSurface(
      write("degenerate.ply", header("ascii", "element vertex 3\n" + float_vertices +
                                                  "element face 5\nproperty list uchar int vertex_indices\n") +
                                  "0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 1\n0\n3 0 1 2\n4 0 0 1 2\n"));
  EXPECT_EQ(surface.size(), 3U);
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
}

TEST_F(ReadPly, CoordinatesThatAreNoFiniteNumbersAreData)
{
  const Surface surface = readSurface(
      write("nan.ply", header("ascii", "element vertex 2\n" + float_vertices) + "NaN -nan inf\n-INF +1 1e999\n"));
  EXPECT_TRUE(std::isnan(surface.points[0][0]));
  EXPECT_TRUE(std::isnan(surface.points[0][1]));
  EXPECT_EQ(surface.points[0][2], INFINITY);
  EXPECT_EQ(surface.points[1], (Vector3{-INFINITY, 1.0F, INFINITY}));
}

TEST_F(ReadPly, NumbersTooSmallForAFloatAreZero)
{
  const Surface surface =
      readSurface(write("tiny.ply", header("ascii", "element vertex 1\n" + float_vertices) + "1e-60 -1e-999 1e-42\n"));
  EXPECT_EQ(surface.points[0], (Vector3{0.0F, 0.0F, 1e-42F}));
}

TEST_F(ReadPly, SurplusValuesOfFacesArePassedOverWithANote)
{
  const std::string text = header("ascii", "element vertex 3\n" + float_vertices +
                                               "element face 3\nproperty list uchar int vertex_indices\n"
                                               "property uchar red\n") +
                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255\n3 2 1 0 9 1 1 1\n3 0 2 1 9 1 1 1\n";
  const Surface surface = readSurface(write("surplus.ply", text));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}, {0, 2, 1}}));
  ASSERT_EQ(surface.notes.size(), 1U);
  EXPECT_NE(surface.notes[0].find("line 17"), std::string::npos) << surface.notes[0];
  EXPECT_NE(surface.notes[0].find("1 further"), std::string::npos) << surface.notes[0];
}

TEST_F(ReadPly, HeaderLinesWithoutKeyword)
{
  const Surface surface = readSurface(
      write("comment.ply", "ply\nformat ascii 1.0\ncomment made by a program that breaks\nits comments into lines\n"
                           "element vertex 1\n" +
                               float_vertices + "end_header\n1 2 3\n"));
  EXPECT_EQ(surface.size(), 1U);
  ASSERT_EQ(surface.notes.size(), 1U);
  EXPECT_NE(surface.notes[0].find("line 4"), std::string::npos) << surface.notes[0];
  EXPECT_NE(surface.notes[0].find("'its'"), std::string::npos) << surface.notes[0];
}

TEST_F(ReadPly, NamesInCapitals)
{
  const Surface surface =
      readSurface(write("upper.ply", header("ascii", "element vertex 1\nproperty float X\nproperty float Y\n"
                                                     "property float Z\n") +
                                         "1 2 3\n"));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}}));
}

TEST_F(ReadPly, FacesThatTakeNoRoomReserveNone)
{
  const std::string vertices = "element vertex 1\n" + float_vertices;
  for (const char* format : {"ascii", "binary_little_endian"}) {
    const std::string point = std::string(format) == "ascii" ? "1 2 3\n" : Bytes().add(1.0F, 2.0F, 3.0F).str();
    const Surface surface =
        readSurface(write("promise.ply", header(format, "element face 2000000000\n" + vertices) + point));
    EXPECT_EQ(surface.size(), 1U);
    EXPECT_EQ(surface.triangles.capacity(), 0U);
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
