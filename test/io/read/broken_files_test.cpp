// What the functions of readers.h refuse, all reached through readSurface (); what they read: read_*_test.cpp.
#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <sys/stat.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using BrokenFiles = TemporaryFolder;

/** \brief A file that must be refused, and what the message must say besides the file's name. */
struct BrokenFile {
  const char* name;
  std::string content;
  std::vector<std::string> words;
};

const std::string ply_mesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"; // 9 lines
const std::string ply_points = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                               "property float z\nend_header\n"; // 7 lines
const std::string pcd_xyz =
    "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n";
const std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n";

std::string
replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

const std::vector<BrokenFile> broken_files = {
    // Any format
    {"empty.ply", "", {"empty"}},
    {"unknown.stp", "0 0 0\n", {"unknown ending", ".stp"}},
    {"xml.vtp", xml, {".vtp files", "not read", "legacy file, .vtk, or as .ply"}},
    {"xml.VTU", xml, {".vtu files", "not read", "legacy file, .vtk, or as .ply"}},
    {"xml.vtk", xml, {"line 1", "XML is not read", "legacy file, or as .ply"}},
    {"packed.ply", "\x1F\x8B\x08", {"compressed by gzip", ".gz"}},
    {"text.ply.gz", "ply\n", {"not compressed by gzip"}},
    {"wide.obj", std::string("\xFF\xFEv\0 \0", 6), {"UTF-16"}},
    {"none", "0 0 0\n", {"unknown ending"}},
    // PLY
    {"magic.ply", "plyx\n", {"line 1", "not a PLY"}},
    {"binary.ply", std::string("\0\1\2\3", 4), {"line 1", "not a PLY"}},
    {"word.ply", ply_points + "0 0 0\n0 abc 0\n", {"line 9", "'abc'", "not a number"}},
    {"garbage.ply", ply_points + "0 0 0\n0 1.5x 0\n", {"line 9", "'1.5x'", "not a number"}},
    {"sign.ply", ply_points + "0 0 0\n0 +-1 0\n", {"line 9", "'+-1'", "not a number"}},
    {"short_line.ply", ply_points + "0.5 0\n0 0 0\n", {"line 8", "line ends", "number"}},
    {"long_line.ply", ply_points + "0 0 0 0\n0 0 0\n", {"line 8", "unexpected '0'"}},
    {"truncated.ply", ply_points + "0.25 0.25 0.25\n", {"line 9", "file ends"}},
    {"too_many.ply", ply_points + "0 0 0\n0 0 0\n0 0 0\n", {"line 10", "unexpected '0'"}},
    {"huge.ply", replaced(ply_points, "vertex 2", "vertex 2000000000") + "0 0 0\n", {"line 3", "too short"}},
    {"more.ply", replaced(ply_points, "vertex 2", "vertex 99999999999") + "0 0 0\n", {"line 3", "99999999999"}},
    {"negative.ply", replaced(ply_points, "vertex 2", "vertex -2") + "0 0 0\n", {"line 3", "-2"}},
    {"count.ply", replaced(ply_points, "vertex 2", "vertex two") + "0 0 0\n", {"line 3", "'two'", "integer"}},
    {"no_z.ply", replaced(ply_points, "float z", "float w") + "0 0 0\n0 0 0\n", {"line 3", "x, y and z"}},
    {"twice_x.ply", replaced(ply_points, "float z", "float x") + "0 0 0\n0 0 0\n", {"line 3", "x, y and z"}},
    {"type.ply", replaced(ply_points, "float z", "real z") + "0 0 0\n0 0 0\n", {"line 6", "'real'"}},
    {"format.ply", replaced(ply_points, "ascii", "text") + "0 0 0\n0 0 0\n", {"line 2", "'text'"}},
    {"version.ply", replaced(ply_points, "1.0", "2.0") + "0 0 0\n0 0 0\n", {"line 2", "'2.0'"}},
    {"no_format.ply", replaced(ply_points, "format ascii 1.0\n", "") + "0 0 0\n0 0 0\n", {"no 'format'"}},
    {"keyword.ply", replaced(ply_points, "element", "elements") + "0 0 0\n0 0 0\n", {"line 3", "'elements'"}},
    {"no_end.ply", replaced(ply_points, "end_header\n", ""), {"file ends", "end_header"}},
    {"no_vertex.ply", replaced(ply_points, "vertex", "node") + "0 0 0\n0 0 0\n", {"no element 'vertex'"}},
    {"no_points.ply", replaced(ply_points, "vertex 2", "vertex 0"), {"holds no point"}},
    {"large_index.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"line 13", "point 3 of 3"}},
    {"minus_index.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"line 13", "point -1 of 3"}},
    {"long_index.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967296\n", {"line 13", "4294967296"}},
    {"real_index.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", {"line 13", "'1.5'", "integer"}},
    {"short_face.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3 0 1  \n", {"line 13", "line ends"}},
    {"long_face.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n3000000000 0 1\n", {"line 13", "3000000000"}},
    {"minus_face.ply", ply_mesh + "0 0 0\n1 0 0\n0 1 0\n-3 0 1\n", {"line 13", "-3"}},
    {"float_face.ply", replaced(ply_mesh, "uchar int", "uchar float") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"integer"}},
    {"float_count.ply",
     replaced(ply_mesh, "uchar int", "float int") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
     {"line 8", "integer"}},
    // PCD
    {"word.pcd", pcd_xyz + "DATA ascii\n0 0 0\n0 0 abc\n", {"line 11", "'abc'", "not a number"}},
    {"short_line.pcd", pcd_xyz + "DATA ascii\n0.5 0\n0 0 0\n", {"line 10", "line ends"}},
    {"long_line.pcd", pcd_xyz + "DATA ascii\n0 0 0 0\n0 0 0\n", {"line 10", "unexpected"}},
    {"truncated.pcd", pcd_xyz + "DATA ascii\n0.25 0.25 0.25\n", {"line 11", "file ends"}},
    {"too_many.pcd", pcd_xyz + "DATA ascii\n0 0 0\n0 0 0\n0 0 0\n", {"line 12", "unexpected"}},
    {"kind.pcd", pcd_xyz + "DATA text\n", {"line 9", "'text'"}},
    {"no_data.pcd", pcd_xyz, {"file ends", "DATA"}},
    {"keyword.pcd", "hello world\n", {"line 1", "'hello'"}},
    {"twice.pcd", "WIDTH 2\n" + pcd_xyz + "DATA ascii\n", {"line 7", "second", "'WIDTH'"}},
    {"no_values.pcd",
     replaced(pcd_xyz, "COUNT 1 1 1", "COUNT 1 1 0") + "DATA ascii\n0 0\n0 0\n",
     {"field 'z'", "not one number"}},
    {"no_z.pcd", replaced(pcd_xyz, "x y z", "x y w") + "DATA ascii\n0 0 0\n0 0 0\n", {"no field 'z'"}},
    {"twice_x.pcd", replaced(pcd_xyz, "x y z", "x x z") + "DATA ascii\n0 0 0\n0 0 0\n", {"two fields 'x'"}},
    {"sizes.pcd", replaced(pcd_xyz, "SIZE 4 4 4", "SIZE 4 4") + "DATA ascii\n", {"line 3", "'SIZE' has 2 values"}},
    {"odd_size.pcd",
     replaced(pcd_xyz, "SIZE 4 4 4", "SIZE 4 4 3") + "DATA ascii\n0 0 0\n0 0 0\n",
     {"field 'z'", "type"}},
    {"zero_size.pcd", replaced(pcd_xyz, "SIZE 4 4 4", "SIZE 4 4 0") + "DATA ascii\n", {"line 3", "'0'"}},
    {"points.pcd", replaced(pcd_xyz, "POINTS 2", "POINTS 3") + "DATA ascii\n", {"line 8", "WIDTH times HEIGHT"}},
    {"minus.pcd", replaced(pcd_xyz, "WIDTH 2", "WIDTH -2") + "DATA ascii\n", {"line 6", "'-2'"}},
    {"no_width.pcd", replaced(pcd_xyz, "WIDTH 2\n", "") + "DATA ascii\n", {"no line 'WIDTH'"}},
    {"huge.pcd",
     replaced(replaced(pcd_xyz, "WIDTH 2", "WIDTH 2000000000"), "POINTS 2", "POINTS 2000000000") +
         "DATA ascii\n0 0 0\n",
     {"too short for 2000000000 points"}},
    {"product.pcd",
     replaced(replaced(pcd_xyz, "WIDTH 2", "WIDTH 2000000000"), "HEIGHT 1", "HEIGHT 2000000000") + "DATA ascii\n",
     {"line 6", "numbered"}},
    {"binary.pcd", pcd_xyz + "DATA binary\n" + std::string(23, 'x'), {"byte 119", "before the last of its 2 points"}},
    {"compressed.pcd",
     pcd_xyz + "DATA binary_compressed\n" + Bytes().add(1000U, 24U).str(),
     {"byte", "within its compressed"}},
    {"compressed_size.pcd",
     pcd_xyz + "DATA binary_compressed\n" + Bytes().add(4U, 23U).str() + "abcd",
     {"byte", "sizes"}},
    {"compressed_ratio.pcd",
     replaced(replaced(pcd_xyz, "WIDTH 2", "WIDTH 300000000"), "POINTS 2", "POINTS 300000000") +
         "DATA binary_compressed\n" + Bytes().add(4U, 3600000000U).str() + "abcd",
     {"byte", "sizes"}},
    {"compressed_data.pcd",
     pcd_xyz + "DATA binary_compressed\n" + Bytes().add(4U, 24U).str() + "\xFF\xFF\xFF\xFF",
     {"byte", "damaged"}},
    // OBJ
    {"word.obj", "v 0 0 0\nv 0 abc 0\n", {"line 2", "'abc'", "not a number"}},
    {"short.obj", "v 0 0\n", {"line 1", "line ends"}},
    {"large_index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\nf 1 2 3\n", {"line 5", "point 4 of 3"}},
    {"zero_index.obj", "v 0 0 0\nf 0 1 1\n", {"line 2", "'0'", "from 1"}},
    {"minus_index.obj", "v 0 0 0\nf -2 1 1\n", {"line 2", "'-2'"}},
    {"corner.obj", "v 0 0 0\nf 1/a 1 1\n", {"line 2", "'1/a'"}},
    {"no_point.obj", "v 0 0 0\nf //1 1 1\n", {"line 2", "'//1'"}},
    {"no_number.obj", "v 0 0 0\nf 1//a 1 1\n", {"line 2", "'1//a'"}},
    {"no_corner.obj", "v 0 0 0\nf\n", {"line 2", "without corners"}},
    {"continued.obj", "v 0 0 0\nv 1 \\\n0 \\\nabc\n", {"line 4", "'abc'"}},
    {"text.obj", "Hello\n", {"holds no point"}},
    // OFF
    {"magic.off", "FOO\n", {"line 1", "'FOO'"}},
    {"office.off", "OFFICE\n", {"line 1", "'OFFICE'", "not an OFF"}},
    {"prefix.off", "XOFF\n1 0 0\n0 0 0\n", {"line 1", "'XOFF'", "not an OFF"}},
    {"dimensions.off", "nOFF\n4\n1 0 0\n0 0 0 1\n", {"line 2", "4 dimensions"}},
    {"counts.off", "OFF BINARY\n" + Bytes(true).add(1, 0).str(), {"ends within a record"}},
    {"colours.off",
     "OFF BINARY\n" + Bytes(true).add(1, 1, 0, 0.0F, 0.0F, 0.0F, 1, 0, 2, 1.0F).str(),
     {"ends within a record"}},
    {"order.off", "OFF BINARY\n" + Bytes().add(1, 0, 0, 1.0F, 2.0F, 3.0F).str(), {"byte 11", "big-endian"}},
    {"binary.off",
     "OFF BINARY\n" + Bytes(true).add(1, 1, 0, 0.0F, 0.0F, 0.0F, 3, 0, 0).str(),
     {"byte 35", "3 corners"}},
    {"binary_corner.off",
     "OFF BINARY\n" + Bytes(true).add(1, 1, 0, 0.0F, 0.0F, 0.0F, 3, 0, 1, 0, 0).str(),
     {"byte 43", "point 1 of 1"}},
    {"counts.off", "OFF\n3\n", {"line 2", "line ends"}},
    {"word_count.off", "OFF\n3 x 0\n", {"line 2", "'x'"}},
    {"huge.off", "OFF\n2000000000 1 0\n0 0 0\n", {"line 2", "too short"}},
    {"huge_faces.off", "OFF\n1 2000000000 0\n0 0 0\n", {"line 2", "too short"}},
    {"negative.off", "OFF\n-1 0 0\n", {"line 2", "-1"}},
    {"word.off", "OFF\n1 0 0\n0 abc 0\n", {"line 3", "'abc'"}},
    {"truncated.off", "OFF\n2 0 0\n0.125 0.125 0.125\n", {"line 4", "file ends"}},
    {"large_index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"line 6", "point 3 of 3"}},
    {"minus_index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"line 6", "point -1 of 3"}},
    {"short_face.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1  \n", {"line 6", "line ends"}},
    {"long_face.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1\n", {"line 6", "2000000000"}},
    {"too_many.off", "OFF\n1 0 0\n0 0 0\n0 0 0\n", {"line 4", "unexpected"}},
    // STL
    {"text.stl", "solid x\nfacets\n", {"line 2", "'facets'"}},
    {"truncated.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", {"file ends", "vertex"}},
    {"word.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 abc\n", {"line 4", "'abc'"}},
    {"four.stl",
     "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n",
     {"line 7", "'endloop'", "'vertex'"}},
    {"no_end.stl", "solid x\n", {"file ends", "endsolid"}},
    {"header.stl", std::string(83, '\0'), {"byte 83", "header"}},
    {"huge.stl",
     std::string(80, '\0') + Bytes().add(0xFFFFFFFFU).str() + std::string(50, '\0'),
     {"byte 134", "4294967295 facets"}},
};

TEST_F(BrokenFiles, MessageNamesFilePlaceAndReason)
{
  for (const BrokenFile& broken : broken_files) {
    SCOPED_TRACE(broken.name);
    const std::string file = write(broken.name, broken.content);
    try {
      readSurface(file);
      ADD_FAILURE() << "was read";
    }
    catch (const IOException& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(file + ": "), std::string::npos) << message;
      for (const std::string& word : broken.words)
        EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
    }
  }
}

/** \brief The message of reading \a file. */
std::string
messageOf(const std::string& file)
{
  try {
    readSurface(file);
  }
  catch (const IOException& error) {
    return error.what();
  }
  return "was read";
}

TEST_F(BrokenFiles, MissingFilesAndWhatIsNoFile)
{
  EXPECT_NE(messageOf(path("missing.ply")).find("missing.ply: cannot be opened: No such file"), std::string::npos);
  std::filesystem::create_directory(path("folder.ply"));
  EXPECT_NE(messageOf(path("folder.ply")).find("folder.ply: is a directory"), std::string::npos);
  ASSERT_EQ(::mkfifo(path("pipe.ply").c_str(), 0600), 0);
  EXPECT_NE(messageOf(path("pipe.ply")).find("pipe.ply: is not a regular file"), std::string::npos);
}

/** \brief Reads a file after it was damaged: either a complaint or a surface whose triangles all refer to points. */
void
expectComplaintOrSurface(const std::string& file)
{
  try {
    const Surface surface = readSurface(file);
    for (const Triangle& triangle : surface.triangles)
      for (const Index corner : triangle)
        ASSERT_TRUE(corner >= 0 && static_cast<std::size_t>(corner) < surface.size());
    ASSERT_TRUE(surface.normals.empty() || surface.normals.size() == surface.size());
  }
  catch (const IOException&) {
  }
}

/** \brief Complete small files of all binary kinds. */
std::vector<std::pair<std::string, std::string>>
binaryFiles()
{
  std::vector<std::pair<std::string, std::string>> files;
  for (const bool big_endian : {false, true}) {
    Bytes bytes(big_endian);
    bytes.add(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0);
    bytes.add(std::uint8_t{3}, 0, 1, 2, std::uint8_t{4}, 0, 1, 2, 3);
    const std::string order = big_endian ? "big" : "little";
    files.emplace_back(order + ".ply",
                       "ply\nformat binary_" + order +
                           "_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                           "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
                           bytes.str());
  }
  Bytes facet;
  for (int i = 0; i < 2; ++i)
    facet.add(0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, std::uint16_t{0});
  files.emplace_back("two.stl", std::string(80, '\0') + Bytes().add(2U).str() + facet.str());
  return files;
}

TEST_F(BrokenFiles, TruncatedAnywhere)
{
  std::vector<std::pair<std::string, std::string>> files = binaryFiles();
  PointCloud<PointNormal> cloud(3, 2);
  io::savePCDFileBinary(path("a.pcd"), cloud);
  io::savePCDFileBinaryCompressed(path("b.pcd"), cloud);
  files.emplace_back("binary.pcd", read(path("a.pcd")));
  files.emplace_back("compressed.pcd", read(path("b.pcd")));
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(readSurface(write(name, content)));
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_THROW(readSurface(write(name, content.substr(0, size))), IOException) << size << " bytes";
  }
}

TEST_F(BrokenFiles, DamagedAnywhere)
{
  std::vector<std::pair<std::string, std::string>> files = binaryFiles();
  PointCloud<PointXYZ> cloud(3, 2);
  io::savePCDFileBinaryCompressed(path("c.pcd"), cloud);
  files.emplace_back("compressed.pcd", read(path("c.pcd")));
  files.emplace_back("binary.off", "CNOFF BINARY\n" + Bytes(true)
                                                          .add(1, 1, 0)
                                                          .add(0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F)
                                                          .add(1.0F, 1.0F, 1.0F, 1.0F)
                                                          .add(3, 0, 0, 0, 1, 0.5F)
                                                          .str());
  files.emplace_back("text.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  files.emplace_back("text.obj", "v 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nf 1/2/1 2//1 -1\n");
  files.emplace_back("texture.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 1 0\nf 1/1 2/2 3/-1\n");
  files.emplace_back("names.xyz", "3\n//X Y Z r g b\n1 2 3 4 5 6\n1,2,3,4,5,6\n-1.5 nan 2e3 0 0 1 # x\n");
  files.emplace_back("plain.xyz", "1;2;3;0;0;1\n-1;-2;-3;1;0;0\n");
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    for (std::size_t i = 0; i < content.size(); ++i) {
      for (const char damage : {'\x00', '\x7F', '\xFF', '9', '-', ' ', '\n'}) {
        std::string damaged = content;
        damaged[i] = damage;
        expectComplaintOrSurface(write(name, damaged));
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
