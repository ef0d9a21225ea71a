#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadObj = TemporaryFolder;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ReadObj, AllFormsOfCorners)
{
  const Surface surface =
      readSurface(write("forms.OBJ", "# made by hand\nmtllib none.mtl\no thing\n" + square +
                                         "vt 0 0\nvt 1 1\nvn 0 0 1\ng group\ns off\nusemtl red\n"
                                         "f 1 2 3\nf 1/1 2/2 3/1 # comment\nf 1//1 2//1 3//1\nf 1/1/1 3/2/1 4/1/1\n"
                                         "f -4 -3 -2 -1\nf 1 2 \\\n 3\nl 1 2\n"));
  EXPECT_EQ(surface.size(), 4U);
  EXPECT_EQ(surface.triangles,
            (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_TRUE(surface.normals.empty()); // one normal for four points belongs to none of them
}

TEST_F(ReadObj, WeightsAndColoursBehindTheCoordinates)
{
  const Surface surface = readSurface(write("colour.obj", "v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\n"));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}}));
}

TEST_F(ReadObj, NormalsOneForEachPoint)
{
  const std::string normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\n";
  const Surface kept = readSurface(write("kept.obj", square + normals + "f 1//1 2//2 3//3\n"));
  ASSERT_EQ(kept.normals.size(), 4U);
  EXPECT_EQ(kept.normals[1], (Vector3{0.0F, 1.0F, 0.0F}));
  const Surface crossed = readSurface(write("crossed.obj", square + normals + "f 1//2 2//1 3//3\n"));
  EXPECT_TRUE(crossed.normals.empty());
}

/** Values of a field of floats. */
std::vector<float>
floatsOf(const Surface& surface, const std::string& name)
{
  std::vector<float> values;
  if (surface.fields != nullptr)
    for (const PointField& field : surface.fields->fields)
      if (field.name == name) {
        values.resize(field.values.size() / sizeof(float));
        std::memcpy(values.data(), field.values.data(), field.values.size());
      }
  return values;
}

TEST_F(ReadObj, TextureCoordinatesAreThoseOfThePointsCorners)
{
  const Surface surface = readSurface(write(
      "texture.obj", square + "vt 0.5 0.25\nvt 1\nvt 0 0.75 0\nf 2/1 1/2 3/3\nf 1/2 3/3 2/-3\n")); // 2/1 once more
  const std::vector<float> u = floatsOf(surface, "u");
  const std::vector<float> v = floatsOf(surface, "v");
  ASSERT_EQ(u.size(), 4U);
  EXPECT_EQ((std::vector<float>{u[0], u[1], u[2]}), (std::vector<float>{1.0F, 0.5F, 0.0F}));
  EXPECT_EQ((std::vector<float>{v[0], v[1], v[2]}), (std::vector<float>{0.0F, 0.25F, 0.75F}));
  EXPECT_TRUE(std::isnan(u[3])) << "of no corner";
  EXPECT_TRUE(surface.notes.empty());
}

TEST_F(ReadObj, AtASeamOfTheTextureTheFirstFaceCounts)
{
  const Surface surface = readSurface(
      write("seam.obj", square + "vt 0 0\nvt 1 1\nvt 1 1\nf 1/1 2/2 3/2\nf 1/2 3/3 4/9\n")); // 3: equal, 4: none
  EXPECT_EQ(floatsOf(surface, "u").at(0), 0.0F);
  EXPECT_TRUE(std::isnan(floatsOf(surface, "u").at(3)));
  ASSERT_EQ(surface.notes.size(), 1U);
  EXPECT_EQ(surface.notes[0].substr(0, 30), "1 points lie on seams of the t");
}

TEST_F(ReadObj, NegativeNumbersCountFromTheCurrentEnd)
{
  const Surface surface =
      readSurface(write("pieces.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -2 -1\n"));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(ReadObj, AFaceMayComeBeforeItsPoints)
{
  const Surface surface = readSurface(write("early.obj", "f 1 2 3\n" + square));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(ReadObj, AnEmptyIndexIsNone)
{
  const std::string normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\n";
  const Surface surface =
      readSurface(write("empty.obj", square + "vt 0 0\n" + normals + "f 1// 2// 3//\nf 1/1/ 3/1/ 4/1/\nf 1/ 2/ 3/\n"));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(surface.normals.size(), 4U) << "one for each point, and no face says otherwise";
}

TEST_F(ReadObj, FacesOfTheFirstVersions)
{
  const Surface surface = readSurface(write("old.obj", square + "fo 1 2 3\nfo -4/-1 -2 -1\n"));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
