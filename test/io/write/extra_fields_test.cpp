// What a file holds besides positions and normals comes out in the labelled file, which is read once more by PCL and by
// the project's own readers.
#include "io/sample_result.h"
#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ExtraFields = TemporaryFolder;

/** \brief roof() as PCD with fields of several types, some of which have names of the labelled file. */
std::string
roofPcd(const std::string& raster = "WIDTH 6\n")
{
  Bytes bytes;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto n = static_cast<std::uint8_t>(i);
    bytes.add(roof().points[i], 0xFF102030U + static_cast<std::uint32_t>(i), 0.5F * static_cast<float>(n),
              std::int64_t{n} - 3, n, static_cast<std::uint8_t>(n + 1), 9.0);
  }
  return "VERSION .7\nFIELDS x y z rgb intensity stamp pair label\nSIZE 4 4 4 4 4 8 1 8\nTYPE F F F U F I U F\n"
         "COUNT 1 1 1 1 1 1 2 1\n" +
         raster + "DATA binary\n" + bytes.str();
}

const PointField*
find(const Surface& surface, const std::string& name)
{
  if (surface.fields == nullptr)
    return nullptr;
  const auto& fields = surface.fields->fields;
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&name](const PointField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/** \brief Values of a field; empty where it is not there or of another type. */
template <typename Number>
std::vector<Number>
valuesOf(const Surface& surface, const std::string& name)
{
  const PointField* const field = find(surface, name);
  if (field == nullptr || field->value_bytes != sizeof(Number))
    return {};
  std::vector<Number> values(field->values.size() / sizeof(Number));
  std::memcpy(values.data(), field->values.data(), field->values.size());
  return values;
}

TEST_F(ExtraFields, SurviveInBothFormatsUnderTheirNames)
{
  const Surface surface = readSurface(write("in.pcd", roofPcd()));
  const std::vector<float> intensities = {0.0F, 0.5F, 1.0F, 1.5F, 2.0F, 2.5F};
  const std::vector<std::uint32_t> colours = {0xFF102030U, 0xFF102031U, 0xFF102032U,
                                              0xFF102033U, 0xFF102034U, 0xFF102035U};
  for (const char* name : {"out.pcd", "out.ply"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path(name), surface, roofSymmetry());
    const Surface again = readSurface(path(name));
    EXPECT_EQ(again.points, surface.points);
    EXPECT_EQ(valuesOf<float>(again, "intensity"), intensities);
    EXPECT_EQ(valuesOf<std::uint32_t>(again, "input_rgb"), colours);
    EXPECT_EQ(valuesOf<double>(again, "input_label"), std::vector<double>(6, 9.0));
    EXPECT_EQ(valuesOf<std::uint32_t>(again, "label"), (std::vector<std::uint32_t>{1, 1, 3, 3, 2, 2})) << "ours";
  }
  const Surface pcd = readSurface(path("out.pcd"));
  EXPECT_EQ(valuesOf<std::int64_t>(pcd, "stamp"), (std::vector<std::int64_t>{-3, -2, -1, 0, 1, 2}));
  EXPECT_EQ(valuesOf<std::uint8_t>(pcd, "pair"), (std::vector<std::uint8_t>{0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6}));
  const Surface ply = readSurface(path("out.ply"));
  EXPECT_EQ(valuesOf<double>(ply, "stamp"), (std::vector<double>{-3, -2, -1, 0, 1, 2}));
  EXPECT_EQ(valuesOf<std::uint8_t>(ply, "pair_1"), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST_F(ExtraFields, PclLoadsThemBesideTheLabels)
{
  writeLabelledSurface(path("out.pcd"), readSurface(write("in.pcd", roofPcd())), roofSymmetry());
  writeLabelledSurface(path("out.ply"), readSurface(path("in.pcd")), roofSymmetry());
  PointCloud<PointXYZI> clouds[2];
  PointCloud<PointXYZL> labels[2];
  ASSERT_EQ(io::loadPCDFile(path("out.pcd"), clouds[0]), 0);
  ASSERT_EQ(io::loadPLYFile(path("out.ply"), clouds[1]), 0);
  ASSERT_EQ(io::loadPCDFile(path("out.pcd"), labels[0]), 0);
  ASSERT_EQ(io::loadPLYFile(path("out.ply"), labels[1]), 0);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(clouds[i].size(), 6U);
    EXPECT_EQ(clouds[i][5].intensity, 2.5F);
    EXPECT_EQ(clouds[i][5].x, 1.0F);
    EXPECT_EQ(labels[i].at(5).label, 2U);
  }
}

TEST_F(ExtraFields, OfAsciiAndOtherByteOrder)
{
  const std::string properties = "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                                 "property uchar red\nproperty ushort ring\nproperty double time\nproperty float u\n";
  std::string text = "ply\nformat ascii 1.0\n" + properties + "end_header\n";
  Bytes bytes(true);
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3 p = roof().points[i];
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " 255 65000 0.1 0.1\n";
    bytes.add(p[0], p[1], p[2], std::uint8_t{255}, std::uint16_t{65000}, 0.1, 0.1F);
  }
  write("a.ply", text);
  write("b.ply", "ply\nformat binary_big_endian 1.0\n" + properties + "end_header\n" + bytes.str());
  for (const char* name : {"a.ply", "b.ply"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path("out.ply"), readSurface(path(name)), roofSymmetry());
    const Surface again = readSurface(path("out.ply"));
    EXPECT_EQ(valuesOf<std::uint8_t>(again, "input_red"), std::vector<std::uint8_t>(6, 255));
    EXPECT_EQ(valuesOf<std::uint16_t>(again, "ring"), std::vector<std::uint16_t>(6, 65000));
    EXPECT_EQ(valuesOf<double>(again, "time"), std::vector<double>(6, 0.1));
    EXPECT_EQ(valuesOf<float>(again, "u"), std::vector<float>(6, 0.1F));
  }
}

TEST_F(ExtraFields, OfALabelledFileThatIsTheInputOnceMore)
{
  const std::string names[] = {"a.ply", "b.ply", "c.ply"};
  writeLabelledSurface(path(names[0]), roof(), roofSymmetry());
  for (std::size_t i = 0; i < 2; ++i)
    writeLabelledSurface(path(names[i + 1]), readSurface(path(names[i])), roofSymmetry());
  const Surface again = readSurface(path(names[2]));
  for (const char* name : {"label", "input_label", "input_input_label"})
    EXPECT_EQ(valuesOf<std::uint32_t>(again, name).size(), 6U) << name;
}

TEST_F(ExtraFields, TheRasterOfAnOrganisedCloud)
{
  const Surface surface = readSurface(write("in.pcd", roofPcd("WIDTH 3\nHEIGHT 2\n")));
  writeLabelledSurface(path("out.pcd"), surface, roofSymmetry());
  writeLabelledSurface(path("out.ply"), surface, roofSymmetry());
  PCLPointCloud2 clouds[2];
  ASSERT_EQ(io::loadPCDFile(path("out.pcd"), clouds[0]), 0);
  ASSERT_EQ(io::loadPLYFile(path("out.ply"), clouds[1]), 0);
  for (const PCLPointCloud2& cloud : clouds) {
    EXPECT_EQ(cloud.width, 3U);
    EXPECT_EQ(cloud.height, 2U);
  }
  for (const char* name : {"out.pcd", "out.ply"}) {
    const Surface again = readSurface(path(name));
    ASSERT_NE(again.fields, nullptr);
    EXPECT_EQ(again.fields->width, 3U);
    EXPECT_EQ(again.fields->height, 2U);
  }
}

TEST_F(ExtraFields, OfAnotherNumberOfPointsAreLeftOut)
{
  Surface surface = roof();
  auto fields = std::make_shared<PointFields>();
  fields->fields.push_back({"short", 'F', 4, 1, std::vector<char>(4)});
  fields->width = 7;
  fields->height = 7;
  surface.fields = fields;
  writeLabelledSurface(path("out.pcd"), surface, roofSymmetry());
  EXPECT_EQ(read(path("out.pcd")).find("short"), std::string::npos);
  EXPECT_EQ(readSurface(path("out.pcd")).size(), 6U);
}

TEST_F(ExtraFields, ColoursOfObjAndOff)
{
  std::string obj;
  std::string off = "CSTOFF\n6 0 0\n";
  std::string binary = "COFF BINARY\n" + Bytes(true).add(6, 0, 0).str();
  for (const Vector3& p : roof().points) {
    const std::string position =
        std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " 0.5 0.25 0.125";
    obj += "v " + position + "\n";
    off += position + " 1 0.75 0.75\n";
    binary += Bytes(true).add(p[0], p[1], p[2], 0.5F, 0.25F, 0.125F, 1.0F).str();
  }
  for (const auto& [name, content] : {std::pair{"a.obj", obj}, {"b.off", off}, {"c.off", binary}}) {
    SCOPED_TRACE(name);
    const Surface surface = readSurface(write(name, content));
    EXPECT_EQ(valuesOf<float>(surface, "red"), std::vector<float>(6, 0.5F));
    EXPECT_EQ(valuesOf<float>(surface, "v"), std::vector<float>(std::string(name) == "b.off" ? 6 : 0, 0.75F));
    EXPECT_EQ(valuesOf<float>(surface, "blue"), std::vector<float>(6, 0.125F));
    EXPECT_EQ(valuesOf<float>(surface, "alpha"), std::vector<float>(std::string(name) == "a.obj" ? 0 : 6, 1.0F));
    writeLabelledSurface(path("out.ply"), surface, roofSymmetry());
    EXPECT_EQ(valuesOf<float>(readSurface(path("out.ply")), "input_red"), std::vector<float>(6, 0.5F));
  }
  EXPECT_EQ(readSurface(write("some.obj", obj + "v 1 2 3\n")).fields, nullptr) << "not all points have a colour";
  EXPECT_EQ(readSurface(write("weight.obj", "v 1 2 3 1\nv 1 2 4 1\n")).fields, nullptr);
}

TEST_F(ExtraFields, TextureCoordinatesOfObjAndOff)
{
  std::string obj;
  std::string off = "STOFF\n6 0 0\n";
  std::string binary = "STOFF BINARY\n" + Bytes(true).add(6, 0, 0).str();
  for (const Vector3& p : roof().points) {
    const std::string position = std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
    obj += "v " + position + "\n";
    off += position + " 0.25 0.75\n";
    binary += Bytes(true).add(p[0], p[1], p[2], 0.25F, 0.75F).str();
  }
  obj += "vt 0.25 0.75\nf 1/1 2/1 3/1\nf 4/1 5/1 6/1\n";
  for (const auto& [name, content] : {std::pair{"a.obj", obj}, {"b.off", off}, {"c.off", binary}}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path("out.ply"), readSurface(write(name, content)), roofSymmetry());
    writeLabelledSurface(path("out.pcd"), readSurface(path(name)), roofSymmetry());
    for (const char* labelled : {"out.ply", "out.pcd"}) {
      EXPECT_EQ(valuesOf<float>(readSurface(path(labelled)), "u"), std::vector<float>(6, 0.25F));
      EXPECT_EQ(valuesOf<float>(readSurface(path(labelled)), "v"), std::vector<float>(6, 0.75F));
    }
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
