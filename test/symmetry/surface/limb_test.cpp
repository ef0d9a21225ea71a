// Limbs: where they are rooted, and what is left without one.
#include "support/prepared.h"
#include "support/symmetric_shapes.h"
#include "symmetry/surface/limb.h"
#include "symmetry/surface/point_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr std::size_t samples = 1500;

/** A ball of radius 1 with a limb along x that ends in a tip at x = 3; tapering or not. */
PreparedSurface
ballWithLimb(double radius_at_root)
{
  const RoundCone ball({0, 0, 0}, 1.0, {0, 0, 0}, 1.0);
  const RoundCone limb({0, 0, 0}, radius_at_root, {2.8, 0, 0}, 0.2);
  return preparedMesh(skinOf({ball, limb}, 0.07));
}

Index
tipOf(const PreparedSurface& surface)
{
  const auto tip = std::max_element(surface.points.begin(), surface.points.end(),
                                    [](const Vector3& a, const Vector3& b) { return a[0] < b[0]; });
  return static_cast<Index>(tip - surface.points.begin());
}

/** x in the unit of ballWithLimb (). */
float
xOf(const PreparedSurface& surface, Index v)
{
  return surface.points[v][0] / surface.scale + static_cast<float>(surface.centre[0]);
}

TEST(Limb, EndsWhereTheTrunkBegins)
{
  for (const double radius_at_root : {0.2, 0.5}) {
    const PreparedSurface surface = ballWithLimb(radius_at_root);
    const std::optional<Limb> limb = findLimb(surface, tipOf(surface), samples);
    ASSERT_TRUE(limb);
    float last_inside = 3.0F;
    float first_outside = -1.0F;
    for (std::size_t v = 0; v < surface.size(); ++v) {
      const float x = xOf(surface, static_cast<Index>(v));
      (limb->holds(static_cast<Index>(v)) ? last_inside : first_outside) =
          limb->holds(static_cast<Index>(v)) ? std::min(last_inside, x) : std::max(first_outside, x);
    }
    EXPECT_NEAR(last_inside, 0.95F, 0.2F) << radius_at_root;
    EXPECT_NEAR(first_outside, 0.95F, 0.2F) << radius_at_root;
    const double mean_radius = 0.5 * (radius_at_root + 0.2);
    EXPECT_NEAR(limb->share, 2.1 * mean_radius / (2.1 * mean_radius + 2.0), 0.05) << radius_at_root;
  }
}

TEST(Limb, IsAsLongAroundAsItsRoot)
{
  const PreparedSurface surface = ballWithLimb(0.2);
  const std::optional<Limb> limb = findLimb(surface, tipOf(surface), samples);
  ASSERT_TRUE(limb);
  EXPECT_NEAR(limb->girth / surface.scale, 2.0 * 3.14159 * 0.2, 0.3) << "paths along edges are longer than the surface";
}

TEST(Limb, IsNoneOfABall)
{
  EXPECT_FALSE(findLimb(preparedMesh(sphereMesh(5)), 0, samples));
}

TEST(Limb, IsLookedForWithTriangles)
{
  PreparedSurface surface = ballWithLimb(0.2);
  surface.triangles.clear();
  EXPECT_FALSE(findLimb(surface, tipOf(surface), samples));
}

TEST(Limb, LeavesTheRestAsItWas)
{
  const PreparedSurface surface = ballWithLimb(0.2);
  const std::optional<Limb> limb = findLimb(surface, tipOf(surface), samples);
  ASSERT_TRUE(limb);
  const PartOfSurface rest = withoutLimb(surface, *limb);
  ASSERT_EQ(rest.points.size(), rest.surface.size());
  ASSERT_EQ(rest.surface.graph.size(), rest.surface.size());
  std::size_t left_out = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    left_out += limb->holds(static_cast<Index>(v)) ? 1U : 0U;
  }
  EXPECT_EQ(rest.surface.size() + left_out, surface.size());
  for (std::size_t i = 0; i < rest.points.size(); ++i) {
    const Index v = rest.points[i];
    EXPECT_FALSE(limb->holds(v));
    EXPECT_EQ(rest.surface.points[i], surface.points[v]);
    EXPECT_EQ(rest.surface.original[i], surface.original[v]);
    EXPECT_EQ(rest.surface.representatives[static_cast<std::size_t>(surface.original[v])], static_cast<Index>(i));
    for (const auto [w, length] : rest.surface.graph.edges(i)) {
      EXPECT_EQ(length, edgeLength(surface.graph, v, rest.points[w]));
    }
  }
  EXPECT_EQ(connectedComponents(rest.surface.graph).sizes.size(), 1U);
  EXPECT_EQ(rest.surface.representatives[static_cast<std::size_t>(surface.original[limb->end])], no_index);
}

/** What hangs on the trunk by the limb alone goes with it. */
TEST(Limb, TakesAlongWhatItCutsOff)
{
  const PreparedSurface surface = ballWithLimb(0.2);
  std::optional<Limb> limb = findLimb(surface, tipOf(surface), samples);
  ASSERT_TRUE(limb);
  for (float& distance : limb->distances) {
    distance = distance < 0.3F * limb->root ? 2.0F * limb->root : distance; // a sleeve without the hand
  }
  const PartOfSurface rest = withoutLimb(surface, *limb);
  EXPECT_EQ(connectedComponents(rest.surface.graph).sizes.size(), 1U);
  EXPECT_FALSE(std::binary_search(rest.points.begin(), rest.points.end(), limb->end));
}

TEST(PointAreas, SumUpToThatOfTheSurface)
{
  const PreparedSurface surface = preparedMesh(sphereMesh(4));
  const std::vector<float> areas = pointAreas(surface);
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  EXPECT_NEAR(sum / (double{surface.scale} * double{surface.scale}), 4.0 * 3.14159, 0.1);
}

} // namespace
