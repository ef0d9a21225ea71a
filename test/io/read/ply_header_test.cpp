// What a PLY header says, and headers that are none. Damaged ones at random: broken_files_test.cpp.
#include "io/read/ply_header.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <utility>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class PlyHeaderTest : public TemporaryFolder {
protected:
  PlyHeader
  header(const std::string& content) const
  {
    return readPlyHeader(FileContent(write("a.ply", content)));
  }

  std::string
  complaint(const std::string& content) const
  {
    const std::string message = messageOf<IOException>([&] { header(content); });
    const std::size_t place = (path("a.ply") + ": ").size();
    return message.size() > place ? message.substr(place) : message;
  }
};

TEST_F(PlyHeaderTest, HoldsElementsAndTheirProperties)
{
  const std::string text = "ply\r\nformat binary_big_endian 1.0\r\ncomment of no meaning\r\nobj_info none\r\n"
                           "element vertex 2\r\nproperty double x\r\nproperty uchar red\r\n"
                           "element face 1\r\nproperty list uint8 int vertex_indices\r\nend_header\r\n";
  const PlyHeader read = header(text + std::string(19, '\n'));
  EXPECT_EQ(read.format, PlyFormat::BigEndian);
  EXPECT_EQ(read.end_byte, text.size()) << "line ends behind it are data";
  EXPECT_EQ(read.end_line, 11U);
  ASSERT_EQ(read.elements.size(), 2U);
  const PlyElement& vertices = read.elements[0];
  EXPECT_EQ(vertices.name, "vertex");
  EXPECT_EQ(vertices.count, 2U);
  EXPECT_EQ(vertices.line, 5U);
  EXPECT_FALSE(vertices.hasLists());
  ASSERT_EQ(vertices.properties.size(), 2U);
  EXPECT_EQ(vertices.properties[0].name, "x");
  EXPECT_EQ(vertices.properties[0].type, ScalarType::Float64);
  EXPECT_EQ(vertices.properties[1].type, ScalarType::UInt8);
  const PlyElement& faces = read.elements[1];
  ASSERT_TRUE(faces.hasLists());
  EXPECT_EQ(faces.properties[0].count_type, ScalarType::UInt8);
  EXPECT_EQ(faces.properties[0].type, ScalarType::Int32);
}

TEST_F(PlyHeaderTest, TypesHaveTwoNames)
{
  const std::pair<const char*, ScalarType> types[] = {
      {"char", ScalarType::Int8},       {"int8", ScalarType::Int8},      {"uchar", ScalarType::UInt8},
      {"uint8", ScalarType::UInt8},     {"short", ScalarType::Int16},    {"int16", ScalarType::Int16},
      {"ushort", ScalarType::UInt16},   {"uint16", ScalarType::UInt16},  {"int", ScalarType::Int32},
      {"int32", ScalarType::Int32},     {"uint", ScalarType::UInt32},    {"uint32", ScalarType::UInt32},
      {"int64", ScalarType::Int64},     {"uint64", ScalarType::UInt64},  {"float", ScalarType::Float32},
      {"float32", ScalarType::Float32}, {"double", ScalarType::Float64}, {"float64", ScalarType::Float64}};
  for (const auto& [name, type] : types) {
    const PlyHeader read =
        header("ply\nformat ascii 1.0\nelement vertex 0\nproperty " + std::string(name) + " list\nend_header\n");
    EXPECT_EQ(read.elements.at(0).properties.at(0).type, type) << name;
    EXPECT_EQ(read.elements[0].properties[0].name, "list") << "a name like any other";
  }
}

TEST_F(PlyHeaderTest, RefusesWhatIsNone)
{
  const std::string head = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(complaint("plyformat\n"), "line 1: does not begin with 'ply': not a PLY file");
  EXPECT_EQ(complaint("ply\nend_header\n"), "line 2: the header has no 'format'");
  EXPECT_EQ(complaint("ply\nformat ascii 2.0\n"), "line 2: version '2.0' of PLY is not known, only 1.0");
  EXPECT_EQ(complaint("ply\nformat text 1.0\n"), "line 2: 'text' is not a format of PLY");
  EXPECT_EQ(complaint(head + "property int x\n"), "line 3: unexpected 'property' in the header");
  EXPECT_EQ(complaint(head + "element vertex -1\n"), "line 3: -1 is no number of elements");
  EXPECT_EQ(complaint(head + "element vertex 2147483648\n"), "line 3: 2147483648 is no number of elements");
  EXPECT_EQ(complaint(head + "element vertex 1\nproperty real x\n"), "line 4: 'real' is not a type of PLY");
  EXPECT_EQ(complaint(head + "element face 1\nproperty list float int x\n"),
            "line 4: the length of a list must be of an integer type");
  EXPECT_EQ(complaint(head + "element vertex 1\n"), "line 4: the file ends where 'end_header' is expected");
}

TEST_F(PlyHeaderTest, RefusesMoreThanTheFileHolds)
{
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                           "element face 2\nproperty list uchar int vertex_index\nend_header\n";
  EXPECT_NO_THROW(header(head + std::string(14, '\0'))) << "three floats and two empty lists";
  EXPECT_EQ(complaint(head + std::string(13, '\0')),
            "line 5: the file is too short for 2 elements 'face', or truncated");
  EXPECT_EQ(complaint(head + std::string(11, '\0')),
            "line 3: the file is too short for 3 elements 'vertex', or truncated");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
