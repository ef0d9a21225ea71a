// What writeLabelledSurface () writes is read back; what it did not write is refused.
#include "io/read/labelled_surface.h"
#include "io/sample_result.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/point_types.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class LabelledSurfaceTest : public TemporaryFolder {
protected:
  /** \brief A file of two points with these fields behind x y z, of a type of PCD. */
  std::string
  points(const std::string& fields, const std::string& type, const std::string& first, const std::string& second) const
  {
    std::string sizes;
    std::string types;
    for (const char c : fields)
      if (c == ' ') {
        sizes += " 4";
        types += " " + type;
      }
    return write("points.pcd", "VERSION .7\nFIELDS x y z" + fields + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types +
                                   "\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n0 0 0" + first +
                                   "\n1 0 0" + second + "\n");
  }

  static std::string
  complaint(const std::string& file)
  {
    return messageOf<IOException>([&file] { readLabelledSurface(file); });
  }
};

TEST_F(LabelledSurfaceTest, IsReadBackFromBothFormats)
{
  const SymmetryResult result = roofSymmetry();
  for (const std::string name : {"roof.ply", "roof.PCD"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path(name), roof(), result);
    const LabelledSurface read = readLabelledSurface(path(name));
    EXPECT_EQ(read.partners, std::vector<std::int64_t>(result.partners.begin(), result.partners.end()));
    ASSERT_EQ(read.labels.size(), result.sides.size());
    for (std::size_t i = 0; i < read.labels.size(); ++i)
      EXPECT_EQ(read.labels[i], static_cast<std::int64_t>(result.sides[i])) << i;
    EXPECT_EQ(read.mesh.polygons.size(), name == "roof.ply" ? roof().triangles.size() : 0U);
  }
}

TEST_F(LabelledSurfaceTest, DoublesAtMapCoordinatesBecomeFloatsNearTheOrigin)
{
  Surface surface = roof();
  surface.offset = {2801234.5, 5401240.25, 103.0};
  for (const std::string name : {"roof.ply", "roof.pcd"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path(name), surface, roofSymmetry());
    PointCloud<PointXYZ> cloud;
    fromPCLPointCloud2(readLabelledSurface(path(name)).mesh.cloud, cloud);
    ASSERT_EQ(cloud.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(cloud[i].data[k], surface.points[i][k] - surface.points[0][k]);
  }
}

TEST_F(LabelledSurfaceTest, RefusesOtherFilesByName)
{
  EXPECT_NE(complaint(path("none.ply")).find("none.ply: cannot be read, or holds no points"), std::string::npos);
  EXPECT_NE(complaint(write("a.txt", "x")).find("a.txt: is neither .ply nor .pcd"), std::string::npos);
  EXPECT_NE(complaint(points(" label", "I", " 1", " 2")).find("has no field 'partner'"), std::string::npos);
  EXPECT_NE(complaint(points(" partner", "I", " 1", " 0")).find("has no field 'label'"), std::string::npos);
  EXPECT_NE(complaint(points(" label partner", "F", " 1 1", " 2 0")).find("field 'partner' holds no integers"),
            std::string::npos);
}

TEST_F(LabelledSurfaceTest, RefusesNumbersOutOfRange)
{
  EXPECT_EQ(complaint(points(" label partner", "I", " 3 1", " 0 -1")), "") << "the ends of the ranges";
  EXPECT_NE(complaint(points(" label partner", "I", " 1 1", " 2 2")).find("partner 2 of point 1 is out of range"),
            std::string::npos);
  EXPECT_NE(complaint(points(" label partner", "I", " 1 -2", " 2 0")).find("partner -2 of point 0 is out of range"),
            std::string::npos);
  EXPECT_NE(complaint(points(" label partner", "I", " 4 1", " 2 0")).find("label 4 of point 0 is out of range"),
            std::string::npos);
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
