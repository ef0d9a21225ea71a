#include "io/sample_result.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

/** \brief Writes a picture, and counts the pixels of each colour in what was written. */
class Picture : public TemporaryFolder {
protected:
  struct Census {
    int width = 0;
    int height = 0;
    std::size_t blue = 0;
    std::size_t orange = 0;
    std::size_t red = 0;  ///< dark, as the axis
    std::size_t grey = 0; ///< neither white nor coloured
    std::size_t white = 0;
  };

  Census
  draw(const Surface& surface, const SymmetryResult& result)
  {
    writePicture(path("picture.png"), surface, result);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path("picture.png").c_str());
    reader->Update();
    vtkImageData* const image = reader->GetOutput();
    EXPECT_EQ(image->GetNumberOfScalarComponents(), 3);
    Census census;
    census.width = image->GetDimensions()[0];
    census.height = image->GetDimensions()[1];
    const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < census.width * census.height; ++i, pixel += 3) {
      const int red = pixel[0];
      const int green = pixel[1];
      const int blue = pixel[2];
      census.blue += blue > red + 60 ? 1U : 0U;
      census.orange += red > blue + 60 && green > blue + 30 ? 1U : 0U;
      census.red += red > 80 && red > green + 60 && red < 160 && green < 40 ? 1U : 0U;
      census.grey += red == green && green == blue && red < 250 ? 1U : 0U;
      census.white += red > 250 && green > 250 && blue > 250 ? 1U : 0U;
    }
    return census;
  }
};

/** \brief The reflection x -> -x of a sphere. */
SymmetryResult
sphereSymmetry(const Surface& sphere)
{
  SymmetryResult result;
  result.status = SymmetryStatus::Symmetric;
  result.confidences.assign(sphere.size(), 1.0F);
  result.support.assign(sphere.size(), 1.0F);
  result.regions.assign(sphere.size(), Region::None);
  std::vector<Index> axis;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    Index partner = no_index;
    for (std::size_t j = 0; j < sphere.size(); ++j)
      if (sphere.points[j] == Vector3{-sphere.points[i][0], sphere.points[i][1], sphere.points[i][2]})
        partner = static_cast<Index>(j);
    result.partners.push_back(partner);
    const float x = sphere.points[i][0];
    result.sides.push_back(x < 0.0F ? Side::Source : x > 0.0F ? Side::Target : Side::Axis);
    if (x == 0.0F)
      axis.push_back(static_cast<Index>(i));
  }
  std::sort(axis.begin(), axis.end(), [&](Index a, Index b) {
    const Vector3& p = sphere.points[static_cast<std::size_t>(a)];
    const Vector3& q = sphere.points[static_cast<std::size_t>(b)];
    return std::atan2(p[1], p[2]) < std::atan2(q[1], q[2]);
  });
  result.axis = {lineThrough(sphere, axis, true)};
  return result;
}

TEST_F(Picture, ShowsBothSidesAndTheAxisOfMeshAndCloud)
{
  Surface sphere = sphereMesh(4);
  const SymmetryResult result = sphereSymmetry(sphere);
  for (const bool as_cloud : {false, true}) {
    SCOPED_TRACE(as_cloud ? "cloud" : "mesh");
    if (as_cloud)
      sphere.triangles.clear();
    const Census census = draw(sphere, result);
    EXPECT_GE(census.width, 1000);
    EXPECT_GE(census.height, 600);
    const auto pixels = static_cast<std::size_t>(census.width) * static_cast<std::size_t>(census.height);
    // Two discs of 1 / 1.08 of the picture's height, each half blue and half orange but for points on the axis.
    EXPECT_GT(census.blue, pixels / 6);
    EXPECT_GT(census.orange, pixels / 6);
    EXPECT_NEAR(static_cast<double>(census.blue), static_cast<double>(census.orange),
                0.1 * static_cast<double>(census.blue));
    EXPECT_GT(census.red, 2000U);
    EXPECT_GT(census.white, pixels / 5);
  }
}

TEST_F(Picture, WithoutASymmetryIsGrey)
{
  const Surface sphere = sphereMesh(3);
  SymmetryResult result;
  result.partners.assign(sphere.size(), no_index);
  result.confidences.assign(sphere.size(), 0.0F);
  result.support.assign(sphere.size(), 0.0F);
  result.sides.assign(sphere.size(), Side::None);
  result.regions.assign(sphere.size(), Region::None);
  const Census census = draw(sphere, result);
  EXPECT_EQ(census.blue + census.orange + census.red, 0U);
  EXPECT_GT(census.grey, 100000U);
}

TEST_F(Picture, StandsUnusablePoints)
{
  Surface surface = roof();
  surface.points[1][0] = std::numeric_limits<float>::quiet_NaN();
  surface.points[4][2] = std::numeric_limits<float>::infinity();
  EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
  surface.triangles.clear();
  EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
  surface.points.assign(6, Vector3{1.0F, 1.0F, 1.0F});
  EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
  for (const float scale : {1e-30F, 3e38F}) {
    surface = roof();
    for (Vector3& point : surface.points)
      for (float& coordinate : point)
        coordinate *= scale / 3.0F;
    EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
    surface.triangles.clear();
    EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
  }
  surface.points.assign(6, Vector3{0.0F, std::numeric_limits<float>::quiet_NaN(), 0.0F});
  EXPECT_GT(draw(surface, roofSymmetry()).white, 0U);
}

TEST_F(Picture, IsTheSameEachTime)
{
  const Surface sphere = sphereMesh(3);
  const SymmetryResult result = sphereSymmetry(sphere);
  writePicture(path("one.png"), sphere, result);
  writePicture(path("two.png"), sphere, result);
  EXPECT_EQ(read(path("one.png")), read(path("two.png")));
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
