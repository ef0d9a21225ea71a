// What VTK's own writers put behind arrays: names of components, keys; and arrays of strings and bits.
#include "support/bytes.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <cstdint>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadVtkMetadata = TemporaryFolder;

const std::vector<Vector3> places = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 1}};
const std::vector<Triangle> roof_faces = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}};

/** As VTK 9.1 writes it for points whose components have names, the second none, and that were asked for their range.
 * The list of words holds an empty one, and both lists hold words that are sections elsewhere. */
const std::string metadata = "METADATA\nCOMPONENT_NAMES\nX%20axis\n\nPOINTS\nINFORMATION 4\n"
                             "NAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1.41421 \n"
                             "NAME number LOCATION test\nDATA 7\n"
                             "NAME words LOCATION test\nDATA 3\none%20thing\nPOLYGONS%202%209\n\n"
                             "NAME word LOCATION test\nDATA DATA%203%20of%20all\n\n";

const std::string names_of_two = "METADATA\nCOMPONENT_NAMES\na\nb\n\n";
const std::string names_of_one = "METADATA\nCOMPONENT_NAMES\nPOINTS\n\n";

std::string
head(int version, const std::string& kind, const std::string& data_set)
{
  return "# vtk DataFile Version " + std::to_string(version) + ".1\nvtk output\n" + kind + "\nDATASET " + data_set +
         "\n";
}

std::string
textPoints()
{
  return "POINTS 5 float\n0 0 0 1 0 0 1 1 0 \n0 1 0 0.5 0.5 1 \n";
}

std::string
binaryPoints()
{
  Bytes bytes(true);
  for (const Vector3& p : places)
    bytes.add(p[0], p[1], p[2]);
  return "POINTS 5 float\n" + bytes.str() + "\n";
}

const std::string text_field = "FIELD FieldData 4\nf%20x 2 1 float\n1 2 \n" + names_of_two +
                               "names 1 3 string\nhello%20you\n\nlast\n\nbits 1 11 bit\n0 1 0 1 0 1 0 1\n0 1 0 \n" +
                               "n 1 1 int\n3 \n" + names_of_one;

/** Strings with one, two, four and eight bytes of length. \param[in] eight_bytes_length of the last of them */
std::string
binaryStrings(std::uint64_t eight_bytes_length)
{
  const auto longer = [](std::size_t length) {
    return std::string(length, 'z');
  };
  return Bytes(true).add(std::uint8_t{0xC0 | 9}).str() + "hello you" + "\xC0" +
         Bytes(true).add(std::uint16_t{0x8000 | 100}).str() + longer(100) +
         Bytes(true).add(std::uint32_t{0x40000000 | 20000}).str() + longer(20000) +
         Bytes(true).add(eight_bytes_length).str() + longer(3);
}

std::string
binaryField(const std::string& strings)
{
  return "FIELD FieldData 4\nf%20x 2 1 float\n" + Bytes(true).add(1.0F, 2.0F).str() + "\n" + names_of_two +
         "names 1 5 string\n" + strings + "\nbits 1 11 bit\nU@\nn 1 1 int\n" + Bytes(true).add(3).str() + "\n" +
         names_of_one;
}

void
expectRoof(const Surface& surface)
{
  EXPECT_EQ(surface.points, places);
  EXPECT_EQ(surface.triangles, roof_faces);
  EXPECT_TRUE(surface.notes.empty());
}

TEST_F(ReadVtkMetadata, BehindThePointsOfText)
{
  expectRoof(readSurface(write("a.vtk", head(4, "ASCII", "POLYDATA") + text_field + textPoints() + metadata +
                                            "POLYGONS 2 9\n4 0 1 2 3 \n3 3 2 4 \n\n")));
  expectRoof(
      readSurface(write("b.vtk", head(5, "ASCII", "POLYDATA") + text_field + textPoints() + metadata +
                                     "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7 \n" + names_of_one +
                                     "CONNECTIVITY vtktypeint64\n0 1 2 3 3 2 4 \n" + names_of_one + "POINT_DATA 5\n")));
  expectRoof(readSurface(write("c.vtk", head(4, "ASCII", "UNSTRUCTURED_GRID") + text_field + textPoints() + metadata +
                                            "CELLS 2 9\n4 0 1 2 3 \n3 3 2 4 \n\nCELL_TYPES 2\n9\n5\n")));
}

TEST_F(ReadVtkMetadata, BehindThePointsOfBytes)
{
  const std::string begin = binaryField(binaryStrings(3)) + binaryPoints() + metadata;
  expectRoof(readSurface(write("a.vtk", head(4, "BINARY", "POLYDATA") + begin + "POLYGONS 2 9\n" +
                                            Bytes(true).add(4, 0, 1, 2, 3, 3, 3, 2, 4).str() + "\n")));
  const std::string offsets = Bytes(true).add(std::int64_t{0}, std::int64_t{4}, std::int64_t{7}).str();
  const std::string corners = Bytes(true).add(0, 1, 2, 3, 3, 2, 4).str();
  expectRoof(
      readSurface(write("b.vtk", head(5, "BINARY", "UNSTRUCTURED_GRID") + begin + "CELLS 3 7\nOFFSETS vtktypeint64\n" +
                                     offsets + "\n" + names_of_one + "CONNECTIVITY vtktypeint32\n" + corners + "\n" +
                                     names_of_one + "CELL_TYPES 2\n" + Bytes(true).add(9, 5).str() + "\n")));
}

/** \brief Without the empty line VTK takes the faces for a part of the metadata: a file to refuse, not one without faces. */
TEST_F(ReadVtkMetadata, ThatHasNoEndIsRefused)
{
  const std::string faces = "POLYGONS 2 9\n4 0 1 2 3 \n3 3 2 4 \n";
  for (const char* unfinished : {"METADATA\n", "METADATA\nINFORMATION 0\n", "METADATA\nCOMPONENT_NAMES\nx\ny\nz\n"}) {
    const std::string path = write("a.vtk", head(4, "ASCII", "POLYDATA") + textPoints() + unfinished + faces);
    expectInMessage(messageOf<IOException>([&] { readSurface(path); }),
                    {"line", "METADATA", "empty line", "'polygons'"});
  }
}

TEST_F(ReadVtkMetadata, RefusesStringsThatAreNotThere)
{
  const std::string points = binaryPoints();
  for (const auto& [strings, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {binaryStrings(1U << 20U), {"within a string of 1048576 bytes"}},
           {binaryStrings(~std::uint64_t{0} >> 2U), {"within a string of 4611686018427387903 bytes"}}}) {
    const std::string path = write("a.vtk", head(4, "BINARY", "POLYDATA") + binaryField(strings) + points);
    expectInMessage(messageOf<IOException>([&] { readSurface(path); }), words);
  }
  const std::string field = "FIELD FieldData 1\nnames 1 2000000000 string\n";
  for (const char* kind : {"ASCII", "BINARY"}) {
    const std::string path = write("a.vtk", head(4, kind, "POLYDATA") + field + std::string("\xC1") + "a\n");
    expectInMessage(messageOf<IOException>([&] { readSurface(path); }), {"ends within 2000000000 strings"});
  }
}

TEST_F(ReadVtkMetadata, TruncatedAnywhereIsRefusedOrACloud)
{
  const std::string content = head(5, "BINARY", "POLYDATA") +
                              binaryField("\xC1"
                                          "a\xC0\xC0\xC0\xC0") +
                              binaryPoints() + metadata + "POLYGONS 2 3\nOFFSETS vtktypeint32\n" +
                              Bytes(true).add(0, 3).str() + "\n" + "CONNECTIVITY vtktypeint32\n" +
                              Bytes(true).add(2, 1, 0).str();
  EXPECT_TRUE(readSurface(write("a.vtk", content)).hasFaces());
  const std::size_t points_end = content.find(metadata);
  const std::size_t faces = content.find("POLYGONS 2 3");
  for (std::size_t size = 0; size < content.size(); ++size) {
    const std::string path = write("a.vtk", content.substr(0, size));
    try {
      const Surface surface = readSurface(path);
      EXPECT_TRUE(size + 1 >= points_end && size <= faces) << size;
      EXPECT_EQ(surface.points, places) << size;
    }
    catch (const IOException&) {
      EXPECT_TRUE(size < points_end || size > faces - metadata.size()) << size;
    }
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
