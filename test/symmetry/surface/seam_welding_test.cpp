#include "base/vector_math.h"
#include "support/prepared.h"
#include "support/shapes.h"
#include "symmetry/surface/mesh_cleaning.h"
#include "symmetry/surface/seam_welding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::size_t
weldSeamsOf(PreparedSurface& surface)
{
  return weldSeams(surface, openSides(surface.size(), surface.triangles));
}

void
append(Surface& to, const Surface& other)
{
  const auto first = static_cast<Index>(to.size());
  to.points.insert(to.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) {
    to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

/** Two grids of rows x 3 vertices beside each other, with a gap between the last column of one and the first of the
 * other. */
Surface
twoPatches(int rows, float gap, float z = 0.0F)
{
  Surface both = gridMesh(3, rows);
  Surface right = both;
  for (Vector3& p : right.points) {
    p[0] += 2.0F + gap;
  }
  append(both, right);
  for (Vector3& p : both.points) {
    p[2] += z;
  }
  return both;
}

/** Every triangle with corners of its own, which rounding has moved. */
Surface
facetsOf(const Surface& surface, float rounding)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> off(-rounding, rounding);
  Surface facets;
  for (const Triangle& t : surface.triangles) {
    const auto first = static_cast<Index>(facets.size());
    for (const Index v : t) {
      const Vector3& p = surface.points[v];
      facets.points.push_back({p[0] + off(random), p[1] + off(random), p[2] + off(random)});
    }
    facets.triangles.push_back({first, first + 1, first + 2});
  }
  return facets;
}

std::size_t
weldedPointsOf(const Surface& surface)
{
  PreparedSurface welded = prepared(surface);
  return weldSeamsOf(welded);
}

TEST(SeamWelding, JoinsPatchesThatDifferInTheLastDigits)
{
  PreparedSurface surface = prepared(twoPatches(5, 1e-6F));
  EXPECT_EQ(weldSeamsOf(surface), 5U);
  EXPECT_EQ(surface.size(), 25U);
  EXPECT_EQ(surface.representatives[15], surface.representatives[2]); // both corners at the lower end of the seam
  EXPECT_EQ(surface.triangles.size(), 32U);
}

TEST(SeamWelding, MakesOneSurfaceOfFacets)
{
  const Surface sphere = sphereMesh(3);
  PreparedSurface surface = prepared(facetsOf(sphere, 1e-5F));
  weldSeamsOf(surface);
  EXPECT_EQ(surface.size(), sphere.size());
  EXPECT_EQ(surface.triangles.size(), sphere.triangles.size());
}

TEST(SeamWelding, ClosesABodyOfRevolutionWhoseLastMeridianWasComputedAnew)
{
  constexpr int around = 24;
  Surface tube;
  for (int i = 0; i <= around; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / around;
    for (int j = 0; j < 10; ++j) {
      tube.points.push_back(
          {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.3F * static_cast<float>(j)});
    }
  }
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j + 1 < 10; ++j) {
      const Index a = 10 * i + j;
      tube.triangles.push_back({a, a + 10, a + 1});
      tube.triangles.push_back({a + 1, a + 10, a + 11});
    }
  }
  ASSERT_NE(tube.points[0], tube.points[10 * around]); // sin (2 pi) is not 0
  EXPECT_EQ(weldedPointsOf(tube), 10U);
}

TEST(SeamWelding, LeavesGapsOpen)
{
  EXPECT_EQ(weldedPointsOf(twoPatches(5, 0.02F)), 0U); // a fiftieth of a side
}

TEST(SeamWelding, KeepsSheetsApartThatAreCloserThanTheTolerance)
{
  // Two sheets half a hundredth of a side apart, each with a seam of its own.
  Surface sheets = twoPatches(5, 1e-6F);
  append(sheets, twoPatches(5, 1e-6F, 0.005F));
  PreparedSurface surface = prepared(sheets);
  EXPECT_EQ(weldSeamsOf(surface), 10U);
  for (const Triangle& t : surface.triangles) {
    EXPECT_EQ(surface.points[t[0]][2], surface.points[t[1]][2]);
    EXPECT_EQ(surface.points[t[0]][2], surface.points[t[2]][2]);
  }
}

TEST(SeamWelding, DoesNotDependOnTheUnitOrTheOrderOfThePoints)
{
  const Surface patches = facetsOf(gridMesh(6, 6), 1e-5F);
  const std::size_t expected = weldedPointsOf(patches);
  EXPECT_EQ(expected, patches.size() - 36U);
  EXPECT_EQ(weldedPointsOf(scaled(patches, {1e-25F, 1e-25F, 1e-25F})), expected);
  EXPECT_EQ(weldedPointsOf(scaled(patches, {1e25F, 1e25F, 1e25F})), expected);
  Surface reversed = patches;
  std::reverse(reversed.points.begin(), reversed.points.end());
  for (Triangle& t : reversed.triangles) {
    for (Index& v : t) {
      v = static_cast<Index>(patches.size()) - 1 - v;
    }
  }
  EXPECT_EQ(weldedPointsOf(reversed), expected);
}

TEST(SeamWelding, LeavesAClosedMeshAlone)
{
  PreparedSurface surface = prepared(sphereMesh(2));
  const std::vector<Triangle> before = surface.triangles;
  EXPECT_EQ(weldSeamsOf(surface), 0U);
  EXPECT_EQ(surface.triangles, before);
}

} // namespace
