#include "picture/mesh_drawing.h"

#include <gtest/gtest.h>

#include <limits>

namespace pcl {
namespace symmetry {
namespace {

TEST(Projection, PutsTheCentreInTheMiddleAndUpwardsUp)
{
  PictureView view;
  view.centre = {1.0F, 2.0F, 3.0F};
  view.width = 2.0F;
  view.height = 1.0F;
  const Projection projection(view, 200, 100);
  EXPECT_EQ(projection.scale(), 100.0F);
  const ScreenPoint middle = projection.project(view.centre);
  EXPECT_EQ(middle.x, 100.0F);
  EXPECT_EQ(middle.y, 50.0F);
  const ScreenPoint corner = projection.project({1.5F, 2.25F, 4.0F});
  EXPECT_EQ(corner.x, 150.0F);
  EXPECT_EQ(corner.y, 25.0F);
  EXPECT_GT(corner.depth, middle.depth);
}

TEST(Projection, EitherSideOfAFaceIsLit)
{
  const Projection projection(PictureView{}, 10, 10);
  EXPECT_EQ(projection.brightness({0.0F, 0.0F, 2.0F}), projection.brightness({0.0F, 0.0F, -1.0F}));
  EXPECT_GT(projection.brightness({0.0F, 0.0F, 1.0F}), projection.brightness({1.0F, -1.0F, 0.0F}));
  EXPECT_GT(projection.brightness({0.0F, 0.0F, 0.0F}), 0.0F) << "no normal";
}

TEST(PanelSize, HasTheShapeOfTheViewWithinLimits)
{
  PictureView view;
  EXPECT_EQ(panelSize(view), (std::array<int, 2>{800, 800}));
  view.width = 100.0F;
  const auto [width, height] = panelSize(view);
  EXPECT_NEAR(static_cast<double>(width) / height, 1.6, 0.01);
}

TEST(DrawMesh, FillsFacesAndSkipsThoseWithoutAPlace)
{
  Surface surface;
  surface.points = {{-0.4F, -0.4F, 0.0F},
                    {0.4F, -0.4F, 0.0F},
                    {0.0F, 0.4F, 0.0F},
                    {0.0F, 0.0F, std::numeric_limits<float>::infinity()}};
  surface.triangles = {{0, 1, 2}, {0, 1, 3}};
  const std::vector<Vector3> normals = meshNormals(surface);
  EXPECT_GT(normals[2][2], 0.0F);
  Rasterizer canvas(20, 20);
  drawMesh(surface, normals, std::vector<Colour>(4, Colour{200, 0, 0}), Projection(PictureView{}, 20, 20), canvas);
  const Image image = canvas.reduce(1);
  const std::size_t middle = 3 * (10 * 20 + 10);
  EXPECT_EQ(image.pixels[middle + 1], 0);
  EXPECT_GT(image.pixels[middle], 100);
  EXPECT_EQ(image.pixels[0], 255) << "white beside it";
}

TEST(SideBySide, JoinsRows)
{
  const Image left = {1, 2, {1, 1, 1, 2, 2, 2}};
  const Image right = {2, 2, {3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6}};
  const Image both = sideBySide(left, right);
  EXPECT_EQ(both.width, 3);
  EXPECT_EQ(both.height, 2);
  EXPECT_EQ(both.pixels, (std::vector<std::uint8_t>{1, 1, 1, 3, 3, 3, 4, 4, 4, 2, 2, 2, 5, 5, 5, 6, 6, 6}));
}

} // namespace
} // namespace symmetry
} // namespace pcl
