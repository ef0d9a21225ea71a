#include "io/sample_result.h"
#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using Writers = TemporaryFolder;

template <typename Cloud>
void
expectLabels(const Cloud& cloud)
{
  const Surface surface = roof();
  const SymmetryResult result = roofSymmetry();
  ASSERT_EQ(cloud.size(), surface.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ((Vector3{cloud[i].x, cloud[i].y, cloud[i].z}), surface.points[i]);
    EXPECT_EQ(cloud[i].label, static_cast<std::uint32_t>(result.sides[i]));
  }
}

/** \brief A field of a cloud as PCL loaded it, by name. */
template <typename Number>
Number
fieldValue(const PCLPointCloud2& cloud, const std::string& name, std::size_t point)
{
  for (const PCLPointField& field : cloud.fields) {
    if (field.name != name)
      continue;
    EXPECT_EQ(static_cast<std::size_t>(getFieldSize(field.datatype)), sizeof(Number)) << name;
    Number value;
    std::memcpy(&value, cloud.data.data() + point * cloud.point_step + field.offset, sizeof(value));
    return value;
  }
  ADD_FAILURE() << "no field " << name;
  return Number();
}

void
expectFields(const PCLPointCloud2& cloud)
{
  const SymmetryResult result = roofSymmetry();
  ASSERT_EQ(std::size_t{cloud.width} * cloud.height, result.partners.size());
  for (std::size_t i = 0; i < result.partners.size(); ++i) {
    EXPECT_EQ(fieldValue<std::int32_t>(cloud, "partner", i), result.partners[i]);
    EXPECT_EQ(fieldValue<float>(cloud, "confidence", i), result.confidences[i]);
    EXPECT_EQ(fieldValue<float>(cloud, "support", i), result.support[i]);
    EXPECT_EQ(fieldValue<std::uint8_t>(cloud, "region", i), static_cast<std::uint8_t>(result.regions[i]));
  }
}

TEST_F(Writers, LabelledPcdLoadsIntoPclPointTypes)
{
  writeLabelledSurface(path("labelled.pcd"), roof(), roofSymmetry());
  PointCloud<PointXYZL> labels;
  ASSERT_EQ(io::loadPCDFile(path("labelled.pcd"), labels), 0);
  expectLabels(labels);
  PointCloud<PointXYZRGBL> colours;
  ASSERT_EQ(io::loadPCDFile(path("labelled.pcd"), colours), 0);
  expectLabels(colours);
  EXPECT_GT(colours[0].b, colours[0].r); // source: blue
  EXPECT_GT(colours[4].r, colours[4].b); // target: orange
  PCLPointCloud2 all;
  ASSERT_EQ(io::loadPCDFile(path("labelled.pcd"), all), 0);
  expectFields(all);
}

TEST_F(Writers, LabelledPlyLoadsIntoPclPointTypes)
{
  writeLabelledSurface(path("labelled.PLY"), roof(), roofSymmetry());
  std::filesystem::rename(path("labelled.PLY"), path("labelled.ply")); // which is what PCL insists on
  PointCloud<PointXYZL> labels;
  ASSERT_EQ(io::loadPLYFile(path("labelled.ply"), labels), 0);
  expectLabels(labels);
  PointCloud<PointXYZRGBL> colours;
  ASSERT_EQ(io::loadPLYFile(path("labelled.ply"), colours), 0);
  expectLabels(colours);
  EXPECT_GT(colours[0].b, colours[0].r);
  EXPECT_GT(colours[4].r, colours[4].b);
  PCLPointCloud2 all;
  ASSERT_EQ(io::loadPLYFile(path("labelled.ply"), all), 0);
  expectFields(all);
  PolygonMesh mesh;
  ASSERT_EQ(io::loadPLYFile(path("labelled.ply"), mesh), 0);
  ASSERT_EQ(mesh.polygons.size(), roof().triangles.size());
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.polygons[i].vertices.at(k), roof().triangles[i][k]);
}

TEST_F(Writers, LabelledSurfaceIsReadBackUnchanged)
{
  Surface surface = roof();
  for (const bool has_normals : {false, true}) {
    if (has_normals)
      surface.normals.assign(surface.size(), Vector3{0.0F, 0.6F, 0.8F});
    surface.points[3][1] = 0.1F;
    for (const char* name : {"again.ply", "again.pcd"}) {
      writeLabelledSurface(path(name), surface, roofSymmetry());
      const Surface again = readSurface(path(name));
      EXPECT_EQ(again.points, surface.points);
      EXPECT_EQ(again.normals, surface.normals);
      EXPECT_EQ(again.triangles, std::string(name) == "again.ply" ? surface.triangles : std::vector<Triangle>());
    }
  }
}

TEST_F(Writers, Tables)
{
  writeMap(path("map.csv"), roofSymmetry());
  EXPECT_EQ(read(path("map.csv")), "vertex,partner,confidence\n0,4,1\n1,5,0.75\n2,2,0.5\n3,-1,0\n4,0,1\n5,1,0.1\n");
  writeCorrespondences(path("matches.csv"), roofSymmetry());
  EXPECT_EQ(read(path("matches.csv")), "source,target,midpoint,cost\n0,4,2,0.25\n1,5,-1,0\n");
}

TEST_F(Writers, AxisHasPointsInOrderAndEdges)
{
  SymmetryResult result = roofSymmetry();
  result.axis = {lineThrough(roof(), {3, 2, 0, 1}, true), lineThrough(roof(), {5, 4}, false)};
  writeAxis(path("axis.ply"), roof(), result);
  const std::string ply = read(path("axis.ply"));
  EXPECT_NE(ply.find("element vertex 6\n"), std::string::npos);
  EXPECT_NE(ply.find("element edge 5\n"), std::string::npos);
  const Bytes edges = Bytes().add(0, 1, 1, 2, 2, 3, 3, 0, 4, 5); // the fourth closes the first curve
  EXPECT_EQ(ply.substr(ply.size() - edges.str().size()), edges.str());

  writeAxis(path("axis.pcd"), roof(), result);
  PointCloud<PointXYZ> cloud;
  ASSERT_EQ(io::loadPCDFile(path("axis.pcd"), cloud), 0);
  const std::size_t order[] = {3, 2, 0, 1, 5, 4};
  for (const char* name : {"axis.ply", "axis.pcd"}) {
    const Surface again = readSurface(path(name));
    ASSERT_EQ(again.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(again.points[i], roof().points[order[i]]);
  }
}

TEST_F(Writers, AxisHasDirectionsAndLengths)
{
  writeAxis(path("axis.ply"), roof(), roofSymmetry());
  const Surface again = readSurface(path("axis.ply"));
  ASSERT_EQ(again.normals.size(), 2U);
  EXPECT_EQ(again.normals[0], (Vector3{0.0F, 0.0F, 1.0F}));
  PointCloud<PointNormal> cloud;
  writeAxis(path("axis.pcd"), roof(), roofSymmetry());
  ASSERT_EQ(io::loadPCDFile(path("axis.pcd"), cloud), 0);
  EXPECT_EQ(cloud[1].normal_z, 1.0F);

  writeAxis(path("axis.csv"), roof(), roofSymmetry());
  EXPECT_EQ(read(path("axis.csv")),
            "curve,x,y,z,normal_x,normal_y,normal_z,across_x,across_y,across_z,arc_length,index,closed\n"
            "0,0,0,0.5,0,0,1,-1,0,0,0,2,0\n"
            "0,0,3,0.5,0,0,1,-1,0,0,0.5,3,0\n");
}

TEST_F(Writers, AnEmptyAxisIsAFileWithoutPoints)
{
  SymmetryResult result = roofSymmetry();
  result.axis.clear();
  writeAxis(path("axis.ply"), roof(), result);
  EXPECT_NE(read(path("axis.ply")).find("element vertex 0\n"), std::string::npos);
}

TEST_F(Writers, UnknownEndingsAreRefused)
{
  EXPECT_THROW(writeLabelledSurface(path("a.obj"), roof(), roofSymmetry()), IOException);
  EXPECT_THROW(writeAxis(path("a"), roof(), roofSymmetry()), IOException);
  EXPECT_THROW(writePicture(path("a.jpg"), roof(), roofSymmetry()), IOException);
  EXPECT_EQ(countFiles(), 0U);
}

TEST_F(Writers, AResultOfAnotherSurfaceIsRefused)
{
  SymmetryResult shorter = roofSymmetry();
  shorter.sides.pop_back();
  EXPECT_THROW(writeLabelledSurface(path("a.ply"), roof(), shorter), BadArgumentException);
  SymmetryResult outside = roofSymmetry();
  outside.partners[0] = 6;
  EXPECT_THROW(writePicture(path("a.png"), roof(), outside), BadArgumentException);
  SymmetryResult axis = roofSymmetry();
  axis.axis[0].points[0] = no_index;
  EXPECT_THROW(writeAxis(path("a.ply"), roof(), axis), BadArgumentException);
  EXPECT_EQ(countFiles(), 0U);
}

TEST_F(Writers, AFailureLeavesTheOldFileAndNothingElse)
{
  EXPECT_THROW(writeMap(path("no/such/folder/map.csv"), roofSymmetry()), IOException);
  std::filesystem::create_directory(path("map.csv"));
  EXPECT_THROW(writeMap(path("map.csv"), roofSymmetry()), IOException);
  EXPECT_EQ(countFiles(), 1U);
  try {
    writeMap("/dev/full", roofSymmetry());
    ADD_FAILURE() << "was written to a full device";
  }
  catch (const IOException& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/full: cannot be written: No space left"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(Writers, AnOldFileIsReplacedAndALinkFollowed)
{
  write("old.csv", "old");
  std::filesystem::permissions(path("old.csv"), std::filesystem::perms(0640));
  std::filesystem::create_symlink("old.csv", path("link.csv"));
  writeMap(path("link.csv"), roofSymmetry());
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.csv")));
  EXPECT_EQ(read(path("old.csv")).substr(0, 6), "vertex");
  EXPECT_EQ(std::filesystem::status(path("old.csv")).permissions(), std::filesystem::perms(0640));
  EXPECT_EQ(countFiles(), 2U);
}

TEST_F(Writers, ALinkToNothingIsFollowedAndALoopRefused)
{
  std::filesystem::create_symlink("new.csv", path("link.csv"));
  writeMap(path("link.csv"), roofSymmetry());
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.csv")));
  EXPECT_EQ(read(path("new.csv")).substr(0, 6), "vertex");
  std::filesystem::create_symlink("loop.csv", path("loop.csv"));
  EXPECT_THROW(writeMap(path("loop.csv"), roofSymmetry()), IOException);
}

TEST_F(Writers, TheLongestNamesWillDo)
{
  const std::string name = std::string(251, 'a') + ".csv";
  writeMap(path(name), roofSymmetry());
  EXPECT_EQ(read(path(name)).substr(0, 6), "vertex");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
