#include "base/bounding_box.h"
#include "symmetry/surface/scale_normalization.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(ScaleNormalization, PutsTheBoxOfACloudAroundTheOrigin)
{
  PreparedSurface surface;
  surface.points = {{1, 2, 3}, {5, 2, 4}, {3, 10, 3}};
  normalizeScale(surface);
  EXPECT_EQ(surface.scale, 0.125F);
  const BoundingBox box = boundingBox(surface.points);
  EXPECT_EQ(box.low, (Vector3{-0.25F, -0.5F, -0.0625F}));
  EXPECT_EQ(box.high, (Vector3{0.25F, 0.5F, 0.0625F}));
}

TEST(ScaleNormalization, GoesByTheLargestComponentOfAMesh)
{
  PreparedSurface surface;
  surface.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {90, 0, 0}, {91, 0, 0}, {90, 1, 0}, {-70, 0, 0}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
  normalizeScale(surface);
  EXPECT_EQ(surface.scale, 0.5F);
  EXPECT_EQ(surface.points[3], (Vector3{0.5F, 0.5F, 0.0F}));
  EXPECT_EQ(surface.points[4], (Vector3{44.5F, -0.5F, 0.0F}));
}

TEST(ScaleNormalization, LeavesASinglePlaceAtItsSize)
{
  PreparedSurface surface;
  surface.points = {{7, 7, 7}, {7, 7, 7}};
  normalizeScale(surface);
  EXPECT_EQ(surface.scale, 1.0F);
  EXPECT_EQ(surface.points[0], (Vector3{0, 0, 0}));
}

} // namespace
