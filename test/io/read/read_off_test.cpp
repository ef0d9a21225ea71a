#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadOff = TemporaryFolder;

TEST_F(ReadOff, CountsOnTheirOwnLineOrTheFirst)
{
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string faces = "3 0 1 2 255 0 0\n4 0 1 2 3 0.5 0.5 0.5 1\n";
  const std::string counts[] = {
      "OFF\n4 2 5\n", "OFF\n4 2\n",   "OFF 4 2 0\n", "OFF # kind\n# counts\n4 2 0 # edges\n\n",
      "OFF4 2 0\n",   "off\n4 2 0\n", "4 2 0\n"};
  for (const std::string& beginning : counts) {
    const Surface surface = readSurface(write("a.off", beginning + points + faces));
    EXPECT_EQ(surface.size(), 4U);
    EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  }
}

TEST_F(ReadOff, PrefixesOfTheKeyword)
{
  struct Case {
    const char* keyword;
    const char* point;
    bool has_normals;
  };
  const Case cases[] = {{"OFF", "1 2 3", false},
                        {"NOFF", "1 2 3 0 0.6 0.8", true},
                        {"COFF", "1 2 3 255 128 0 255", false},
                        {"CNOFF", "1 2 3 0 0.6 0.8 0.1 0.2 0.3 1", true},
                        {"STOFF", "1 2 3 0.5 0.5", false},
                        {"NCSTOFF", "1 2 3 0 0.6 0.8 0.1 0.2 0.3 1 0.5 0.5", true},
                        {"4OFF", "2 4 6 2", false},
                        {"N4OFF", "2 4 6 2 0 0.6 0.8", true},
                        {"nOFF 3", "1 2 3", false},
                        {"nNOFF\n3\n", "1 2 3 0 0.6 0.8", true},
                        {"STCNOFF", "1 2 3 0 0.6 0.8 0.1 0.2 0.3 1 0.5 0.5", true}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.keyword);
    const Surface surface = readSurface(write("b.Off", std::string(c.keyword) + "\n1 0 0\n" + c.point + "\n"));
    EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}}));
    const std::vector<Vector3> normals(c.has_normals ? 1 : 0, Vector3{0.0F, 0.6F, 0.8F});
    EXPECT_EQ(surface.normals, normals);
  }
}

TEST_F(ReadOff, BinaryIsBigEndian)
{
  struct Case {
    const char* keyword;
    Bytes point;
    bool has_normals;
  };
  const auto bytes = [] {
    return Bytes(true);
  };
  const Case cases[] = {
      {"OFF", bytes().add(1.0F, 2.0F, 3.0F), false},
      {"STNCOFF", bytes().add(1.0F, 2.0F, 3.0F, 0.0F, 0.6F, 0.8F, 0.1F, 0.2F, 0.3F, 1.0F).add(0.5F, 0.5F), true},
      {"4NOFF", bytes().add(2.0F, 4.0F, 6.0F, 2.0F, 0.0F, 0.6F, 0.8F), true}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.keyword);
    std::string content = std::string(c.keyword) + " BINARY\n" + bytes().add(3, 2, 0).str();
    for (int i = 0; i < 3; ++i)
      content += c.point.str();
    content += bytes().add(3, 0, 1, 2, 0).add(3, 2, 1, 0, 4, 1.0F, 0.5F, 0.5F, 1.0F).str(); // without, with a colour
    const Surface surface = readSurface(write("c.off", content));
    EXPECT_EQ(surface.points, std::vector<Vector3>(3, Vector3{1.0F, 2.0F, 3.0F}));
    EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}}));
    EXPECT_EQ(surface.normals, std::vector<Vector3>(c.has_normals ? 3 : 0, Vector3{0.0F, 0.6F, 0.8F}));
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
