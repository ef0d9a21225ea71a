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
  const std::string counts[] = {"OFF\n4 2 5\n", "OFF\n4 2\n", "OFF 4 2 0\n", "OFF # kind\n# counts\n4 2 0 # edges\n\n"};
  for (const std::string& beginning : counts) {
    const Surface surface = readSurface(write("a.off", beginning + points + faces));
    EXPECT_EQ(surface.size(), 4U);
    EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  }
}

TEST_F(ReadOff, PointsTooFarFromTheOriginForTheirExtentAreRefused)
{
  const std::string faces = "3 0 1 2\n";
  EXPECT_NO_THROW(readSurface(write("near.off", "OFF\n3 1 0\n4000 0 0\n4001 0 0\n4000 1 0\n" + faces)));
  try {
    readSurface(write("far.off", "OFF\n3 1 0\n500000 4500000 0\n500001 4500000 0\n500000 4500001 0\n" + faces));
    ADD_FAILURE() << "was read with two steps across";
  }
  catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("too far from the origin"), std::string::npos) << error.what();
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
                        {"STCNOFF", "1 2 3 0 0.6 0.8 0.1 0.2 0.3 1 0.5 0.5", true}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.keyword);
    const Surface surface = readSurface(write("b.Off", std::string(c.keyword) + "\n1 0 0\n" + c.point + "\n"));
    EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}}));
    const std::vector<Vector3> normals(c.has_normals ? 1 : 0, Vector3{0.0F, 0.6F, 0.8F});
    EXPECT_EQ(surface.normals, normals);
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
