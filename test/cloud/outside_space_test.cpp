#include "cloud/clouds.h"
#include "cloud/outside_space.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float sphere_radius = 0.4F;

/** A sphere of discs, with a hole in the top of the given width. */
std::vector<Surfel>
sphereOfSurfels(float hole = 0.0F)
{
  std::vector<Surfel> surfels;
  for (const Vector3& p : sphereCloud(2000, sphere_radius)) {
    if (distance(p, {0.0F, 0.0F, sphere_radius}) > hole) {
      surfels.push_back({p, normalized(p), 0.03F});
    }
  }
  return surfels;
}

TEST(OutsideSpace, EndsAtAClosedSurface)
{
  const OutsideSpace outside(sphereOfSurfels(), 0.02F);
  EXPECT_FALSE(outside.contains({0.0F, 0.0F, 0.0F}));
  EXPECT_TRUE(outside.contains({10.0F, 0.0F, 0.0F}));
  for (const Vector3& p : sphereCloud(500, 1.0F)) {
    EXPECT_FALSE(outside.contains((sphere_radius - 0.06F) * p));
    EXPECT_TRUE(outside.contains((sphere_radius + 0.06F) * p));
  }
}

TEST(OutsideSpace, ReachesInThroughAHoleWiderThanACube)
{
  EXPECT_TRUE(OutsideSpace(sphereOfSurfels(0.1F), 0.02F).contains({0.0F, 0.0F, 0.0F}));
  EXPECT_FALSE(OutsideSpace(sphereOfSurfels(0.03F), 0.06F).contains({0.0F, 0.0F, 0.0F}));
}

TEST(OutsideSpace, TakesLargerCubesInsteadOfTooMany)
{
  const OutsideSpace outside(sphereOfSurfels(), 1e-5F);
  EXPECT_GT(outside.cube(), 1e-4F);
  EXPECT_FALSE(outside.contains({0.0F, 0.0F, 0.0F}));
}

} // namespace
