// Scenes by assimp, where the library is built with PCL_SYMMETRY_WITH_ASSIMP.
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
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
