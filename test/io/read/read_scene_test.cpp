// Scenes by assimp, where the library is built with PCL_SYMMETRY_WITH_ASSIMP.
#include "support/bytes.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <boost/crc.hpp>
#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <cstdint>
#include <utility>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadScene = TemporaryFolder;

/** Two of them equal, the last of no face, and in an order that no tool would choose. */
const std::vector<Vector3> places = {{1, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {9, 9, 9}};

std::string
padded(std::string text, char filler)
{
  text.resize((text.size() + 3) / 4 * 4, filler);
  return text;
}

/** A binary glTF file: the positions above, a primitive for each list of corners.
 * \param[in] nodes JSON of the nodes, the first of which is the scene's */
std::string
glb(const std::vector<std::vector<std::uint16_t>>& primitives, const std::string& nodes)
{
  std::string data;
  for (const Vector3& p : places)
    data += Bytes().add(p[0], p[1], p[2]).str();
  std::string views = R"({"buffer":0,"byteOffset":0,"byteLength":72})";
  std::string accessors =
      R"({"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,0],"max":[9,9,9]})";
  std::string meshes;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const std::string bytes = std::to_string(2 * primitives[i].size());
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(data.size()) + R"(,"byteLength":)" + bytes + "}";
    accessors += R"(,{"bufferView":)" + std::to_string(i + 1) + R"(,"componentType":5123,"type":"SCALAR","count":)" +
                 std::to_string(primitives[i].size()) + "}";
    meshes +=
        (i == 0 ? "" : ",") + std::string(R"({"attributes":{"POSITION":0},"indices":)") + std::to_string(i + 1) + "}";
    for (const std::uint16_t corner : primitives[i])
      data += Bytes().add(corner).str();
    data = padded(data, '\0');
  }
  const std::string json = padded(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
                                      R"(],"meshes":[{"primitives":[)" + meshes + R"(]}],"buffers":[{"byteLength":)" +
                                      std::to_string(data.size()) + R"(}],"bufferViews":[)" + views +
                                      R"(],"accessors":[)" + accessors + "]}",
                                  ' ');
  const auto size = [](std::size_t bytes) {
    return Bytes().add(static_cast<std::uint32_t>(bytes)).str();
  };
  return "glTF" + size(2) + size(28 + json.size() + data.size()) + size(json.size()) + "JSON" + json +
         size(data.size()) + std::string("BIN\0", 4) + data;
}

const std::string one_node = R"({"mesh":0})";

TEST_F(ReadScene, PointsKeepTheirNumbers)
{
  const Surface surface = readSurface(write("a.glb", glb({{3, 2, 1, 3, 1, 0, 2, 4, 0}}, one_node)));
  EXPECT_EQ(surface.points, places);
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{3, 2, 1}, {3, 1, 0}, {2, 4, 0}}));
}

TEST_F(ReadScene, PartsThatShareTheirPointsShareTheirNumbers)
{
  const Surface surface = readSurface(write("a.glb", glb({{3, 2, 1}, {3, 1, 0}}, one_node)));
  EXPECT_EQ(surface.points, places);
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{3, 2, 1}, {3, 1, 0}}));
}

TEST_F(ReadScene, AMeshIsWhereItsNodesPutIt)
{
  const Surface surface =
      readSurface(write("a.glb", glb({{3, 2, 1}}, R"({"mesh":0,"translation":[10,0,0],"children":[1]},
                                                   {"mesh":0,"translation":[0,5,0],"scale":[1,-1,1]})")));
  ASSERT_EQ(surface.size(), 12U);
  EXPECT_EQ(surface.points[0], (Vector3{11, 1, 0}));
  EXPECT_EQ(surface.points[6], (Vector3{11, 4, 0}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{3, 2, 1}, {9, 8, 7}}));
}

/** A zip archive of entries as they are, not compressed. */
std::string
zip(const std::vector<std::pair<std::string, std::string>>& entries)
{
  const auto two = [](std::size_t number) {
    return Bytes().add(static_cast<std::uint16_t>(number)).str();
  };
  const auto four = [](std::size_t number) {
    return Bytes().add(static_cast<std::uint32_t>(number)).str();
  };
  std::string files;
  std::string directory;
  for (const auto& [name, content] : entries) {
    boost::crc_32_type sum;
    sum.process_bytes(content.data(), content.size());
    // Version, flags, method, time, the first of January 1980, sum, both sizes, lengths of name and of nothing else.
    const std::string description = two(20) + two(0) + two(0) + two(0) + two(0x21) + four(sum.checksum()) +
                                    four(content.size()) + four(content.size()) + two(name.size()) + two(0);
    directory += "PK\x01\x02" + two(20) + description + two(0) + two(0) + two(0) + four(0) + four(files.size()) + name;
    files += "PK\x03\x04" + description + name + content;
  }
  return files + directory + "PK\x05\x06" + two(0) + two(0) + two(entries.size()) + two(entries.size()) +
         four(directory.size()) + four(files.size()) + two(0);
}

/** \param[in] faces of an object of the places above, each \param[in] items of the build */
std::string
threeMf(const std::vector<std::vector<Triangle>>& faces, const std::string& items)
{
  std::string objects;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    objects += R"(<object id=")" + std::to_string(i + 1) + R"(" type="model"><mesh><vertices>)";
    for (const Vector3& p : places)
      objects += R"(<vertex x=")" + std::to_string(p[0]) + R"(" y=")" + std::to_string(p[1]) + R"(" z=")" +
                 std::to_string(p[2]) + R"(" />)";
    objects += "</vertices><triangles>";
    for (const Triangle& t : faces[i])
      objects += R"(<triangle v1=")" + std::to_string(t[0]) + R"(" v2=")" + std::to_string(t[1]) + R"(" v3=")" +
                 std::to_string(t[2]) + R"(" />)";
    objects += "</triangles></mesh></object>";
  }
  const std::string first = R"(<?xml version="1.0" encoding="UTF-8"?>)";
  return zip(
      {{"[Content_Types].xml",
        first + R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels"
          ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model"
          ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
       {"_rels/.rels",
        first + R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship
          Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
          </Relationships>)"},
       {"3D/3dmodel.model",
        first +
            R"(<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)" +
            objects + "</resources><build>" + items + "</build></model>"}});
}

TEST_F(ReadScene, PointsOf3mfKeepTheirNumbers)
{
  const std::vector<Triangle> faces = {{3, 2, 1}, {3, 1, 0}, {2, 4, 0}};
  const Surface surface = readSurface(write("a.3MF", threeMf({faces}, R"(<item objectid="1" />)")));
  EXPECT_EQ(surface.points, places);
  EXPECT_EQ(surface.triangles, faces);
}

TEST_F(ReadScene, ObjectsOf3mfComeInTheOrderOfTheFile)
{
  const Surface surface =
      readSurface(write("a.3mf", threeMf({{{3, 2, 1}}, {{0, 1, 2}}}, R"(<item objectid="1" /><item objectid="2"
                                          transform="1 0 0 0 1 0 0 0 1 10 20 30" />)")));
  ASSERT_EQ(surface.size(), 12U);
  EXPECT_EQ(surface.points[5], places[5]);
  EXPECT_EQ(surface.points[6], (Vector3{11, 21, 30}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{3, 2, 1}, {6, 7, 8}}));
}

TEST_F(ReadScene, NoOtherFileIsOpened)
{
  std::string bytes;
  for (const Vector3& p : places)
    bytes += Bytes().add(p[0], p[1], p[2]).str();
  const std::string beside = write("beside.bin", bytes);
  const std::string scene =
      write("a.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
          "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":72,"uri":")" +
                          beside + R"("}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":72}],
          "accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"}]})");
  expectInMessage(messageOf<IOException>([&] { readSurface(scene); }), {"a.gltf"});
}

TEST_F(ReadScene, RefusesWhatIsNone)
{
  const std::string whole = glb({{3, 2, 1}}, one_node);
  expectInMessage(messageOf<IOException>([&] { readSurface(write("a.glb", "glTF")); }), {"a.glb", "assimp"});
  expectInMessage(messageOf<IOException>([&] { readSurface(write("a.glb", whole.substr(0, whole.size() - 40))); }),
                  {"a.glb", "assimp"});
  expectInMessage(messageOf<IOException>([&] { readSurface(write("a.3mf", "PK")); }), {"a.3mf", "assimp"});
  // A zip archive ends with 22 bytes that say where its directory is.
  const std::string whole_3mf = threeMf({{{3, 2, 1}}}, R"(<item objectid="1" />)");
  for (const std::size_t size : {whole_3mf.size() - 22, whole_3mf.size() / 2, std::size_t{30}})
    expectInMessage(messageOf<IOException>([&] { readSurface(write("a.3mf", whole_3mf.substr(0, size))); }), {"a.3mf"});
  const std::string wrong_corner = threeMf({{{3, 2, 6}}}, R"(<item objectid="1" />)");
  expectInMessage(messageOf<IOException>([&] { readSurface(write("a.3mf", wrong_corner)); }),
                  {"a.3mf", "point 6 of 6"});
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
