#include "model/write_model.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

using namespace pcl::symmetry;

namespace {

namespace fs = std::filesystem;

class WriteModel : public testing::Test {
protected:
  void
  SetUp() override
  {
    std::string pattern = (fs::temp_directory_path() / "pcl_symmetry.XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    surface_.points = {{0.0F, 0.1F, 1.0F / 3.0F}, {1.0F, -2.5e-8F, 3e7F}, {0.0F, 1.0F, 0.0F}};
    surface_.triangles = {{0, 1, 2}};
  }

  void
  TearDown() override
  {
    fs::remove_all(folder_);
  }

  std::string
  file(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  static std::string
  bytesOf(const std::string& path)
  {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string
  packedPoints() const
  {
    std::string bytes(surface_.size() * sizeof(Vector3), '\0');
    std::memcpy(bytes.data(), surface_.points.data(), bytes.size());
    return bytes;
  }

  fs::path folder_;
  Surface surface_;
};

TEST_F(WriteModel, PlyIsBinaryWithFaces)
{
  writePlainSurface(file("a.ply"), surface_);
  const std::string face("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  EXPECT_EQ(bytesOf(file("a.ply")),
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                packedPoints() + face);
}

TEST_F(WriteModel, PcdIsBinaryAndHoldsThePoints)
{
  writePlainSurface(file("a.PCD"), surface_);
  const std::string bytes = bytesOf(file("a.PCD"));
  const std::string end = "POINTS 3\nDATA binary\n";
  ASSERT_NE(bytes.find(end), std::string::npos);
  EXPECT_EQ(bytes.substr(bytes.find(end) + end.size()), packedPoints());
  EXPECT_NE(bytes.find("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"), std::string::npos);
}

TEST_F(WriteModel, OffReadsBackToTheSameFloats)
{
  writePlainSurface(file("a.off"), surface_);
  std::ifstream stream(file("a.off"));
  std::string word;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t edges = 1;
  stream >> word >> points >> faces >> edges;
  EXPECT_EQ(word, "OFF");
  ASSERT_EQ(points, 3U);
  EXPECT_EQ(faces, 1U);
  EXPECT_EQ(edges, 0U);
  for (const Vector3& expected : surface_.points)
    for (const float coordinate : expected) {
      stream >> word;
      EXPECT_EQ(std::strtof(word.c_str(), nullptr), coordinate);
    }
  int corners = 0;
  Triangle triangle = {};
  stream >> corners >> triangle[0] >> triangle[1] >> triangle[2];
  EXPECT_EQ(corners, 3);
  EXPECT_EQ(triangle, surface_.triangles[0]);
}

TEST_F(WriteModel, ObjCountsFromOne)
{
  surface_.points = {{0, 0.5F, 0}, {1, 0, 0}, {0, 1, -4}};
  writePlainSurface(file("a.obj"), surface_);
  EXPECT_EQ(bytesOf(file("a.obj")), "v 0 0.5 0\nv 1 0 0\nv 0 1 -4\nf 1 2 3\n");
}

TEST_F(WriteModel, TruthLeavesOutPointsWithoutPartner)
{
  writeTruth(file("truth.txt"), {2, no_index, 0, 3});
  EXPECT_EQ(bytesOf(file("truth.txt")), "1 3\n3 1\n4 4\n");
}

TEST_F(WriteModel, RejectsUnknownEndings)
{
  EXPECT_THROW(writePlainSurface(file("a.stl"), surface_), std::invalid_argument);
  EXPECT_THROW(checkSurfaceFileName("ply"), std::invalid_argument);
  EXPECT_NO_THROW(checkSurfaceFileName("a.Ply"));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(WriteModel, FailureNamesTheFileAndLeavesNothingBehind)
{
  fs::create_directory(folder_ / "taken.ply");
  try {
    writePlainSurface(file("taken.ply"), surface_);
    FAIL() << "a folder was overwritten";
  }
  catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(file("taken.ply")), std::string::npos);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
  EXPECT_THROW(writeTruth(file("missing/truth.txt"), {0}), std::runtime_error);
}

} // namespace
