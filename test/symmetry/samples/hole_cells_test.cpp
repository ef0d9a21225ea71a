#include "cloud/clouds.h"
#include "model/disturb.h"
#include "support/shapes.h"
#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/hole_cells.h"
#include "symmetry/surface/surface_preparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A sphere of radius 0.5 without its points that lie higher than \a top. */
Surface
sphereBelow(float top)
{
  Surface sphere = sphereMesh(5);
  for (Vector3& p : sphere.points) {
    p = 0.5F * p;
  }
  Model model;
  model.surface = sphere;
  model.partners.resize(sphere.size());
  std::iota(model.partners.begin(), model.partners.end(), 0);
  std::vector<char> keep(sphere.size());
  std::transform(sphere.points.begin(), sphere.points.end(), keep.begin(),
                 [top](const Vector3& p) { return p[2] <= top ? 1 : 0; });
  keepVertices(model, keep);
  return model.surface;
}

PreparedSurface
preparedAs(bool cloud, Surface surface)
{
  if (cloud) {
    surface.triangles.clear();
  }
  return prepareSurface(surface, SymmetryParameters{}, nearestNeighbours);
}

/** Mesh or cloud. */
class CellsAtHoles : public testing::TestWithParam<bool> {
protected:
  static std::ptrdiff_t
  count(const Surface& surface)
  {
    const CoarseSurface coarse = coarsenSurface(preparedAs(GetParam(), surface), 2500);
    return std::count(coarse.at_hole.begin(), coarse.at_hole.end(), 1);
  }
};

TEST_P(CellsAtHoles, AreThoseAroundAHole)
{
  const PreparedSurface surface = preparedAs(GetParam(), sphereBelow(0.493F)); // 0.17 wide
  const CoarseSurface coarse = coarsenSurface(surface, 2500);
  ASSERT_EQ(coarse.at_hole.size(), coarse.size());
  const float rim = (*std::max_element(surface.points.begin(), surface.points.end(),
                                       [](const Vector3& a, const Vector3& b) { return a[2] < b[2]; }))[2];
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const float below = rim - coarse.points[i][2];
    if (below < 0.003F) {
      EXPECT_NE(coarse.at_hole[i], 0) << below;
    }
    else if (below > 0.05F) {
      EXPECT_EQ(coarse.at_hole[i], 0) << below;
    }
  }
}

TEST_P(CellsAtHoles, AreNoneOnAClosedSurface)
{
  EXPECT_EQ(count(sphereBelow(1.0F)), 0);
}

TEST_P(CellsAtHoles, AreNoneAtACrack)
{
  EXPECT_EQ(count(sphereBelow(0.4999F)), 0); // one vertex is missing
}

TEST_P(CellsAtHoles, AreNoneAtTheBorderOfAnOpenSurface)
{
  EXPECT_EQ(count(sphereBelow(0.2F)), 0);
}

INSTANTIATE_TEST_SUITE_P(Input, CellsAtHoles, testing::Bool(), [](const auto& tested) {
  return tested.param ? "Cloud" : "Mesh";
});

} // namespace
