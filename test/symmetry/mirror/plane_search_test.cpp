#include "base/bounding_box.h"
#include "support/boxes.h"
#include "support/known_body.h"
#include "support/prepared.h"
#include "support/shapes.h"
#include "symmetry/mirror/plane_search.h"
#include "symmetry/samples/coarse_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<MirrorFit>
planesOf(const Surface& mesh)
{
  const PreparedSurface surface = preparedMesh(mesh);
  const CoarseSurface coarse = coarsenSurface(surface, 800);
  return findMirrorPlanes({coarse.points, coarse.normals, coarse.areas}, surface, PlaneSearchSettings{});
}

/** Turned about an axis that none of the shapes has. */
Surface
turned(Surface mesh)
{
  const float c = std::cos(0.7F);
  const float s = std::sin(0.7F);
  for (Vector3& p : mesh.points) {
    p = {c * p[0] - s * p[1], 0.8F * (s * p[0] + c * p[1]) - 0.6F * p[2], 0.6F * (s * p[0] + c * p[1]) + 0.8F * p[2]};
  }
  return mesh;
}

/** A box of a few corners as a mesh of many. */
Surface
splitOften(Surface mesh)
{
  for (int round = 0; round < 4; ++round) {
    mesh = finer(mesh);
  }
  return mesh;
}

TEST(FindMirrorPlanes, FindsNoneWhereFacesFillSpace)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> place(0.0F, 1.0F);
  std::uniform_int_distribution<Index> vertex(0, 399);
  Surface faces;
  for (int v = 0; v < 400; ++v) {
    faces.points.push_back({place(random), place(random), place(random)});
  }
  for (int t = 0; t < 1600; ++t) {
    faces.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  }
  EXPECT_TRUE(planesOf(faces).empty()) << "every image of every point lies near some face";
}

TEST(FindMirrorPlanes, FindsThePlaneOfABodyAtRestInAnyPosition)
{
  const Model model = body(Body::Human, 0.0);
  for (const Surface& mesh : {model.surface, turned(model.surface)}) {
    const std::vector<MirrorFit> planes = planesOf(mesh);
    ASSERT_EQ(planes.size(), 1U);
    EXPECT_GT(planes[0].share, 0.99F);
    // It swaps the partners, in the unit box too.
    const PreparedSurface surface = preparedMesh(mesh);
    for (std::size_t v = 0; v < surface.size(); v += 7) {
      const Index partner = model.partners[v];
      if (partner != no_index) {
        EXPECT_LT(distance(planes[0].plane.image(surface.points[v]), surface.points[partner]), 0.005F);
      }
    }
  }
}

TEST(FindMirrorPlanes, FindsThatOfMostWhereTheRestIsFittedOn)
{
  Surface chair = chairOfBoxes();
  addBox(chair, {0.3F, -0.25F, 0.4F}, {0.7F, 0.2F, 0.45F}); // a table at one arm, a fifth of the area
  const std::vector<MirrorFit> planes = planesOf(splitOften(chair));
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_TRUE(planes[0].is_of_part);
  EXPECT_GT(std::abs(planes[0].plane.normal[0]), 0.9999F);
  EXPECT_GT(planes[0].share, 0.7F);
  EXPECT_LT(planes[0].share, 0.9F);
  const std::vector<MirrorFit> whole = planesOf(splitOften(chairOfBoxes()));
  ASSERT_FALSE(whole.empty());
  EXPECT_FALSE(whole[0].is_of_part);
}

TEST(FindMirrorPlanes, WhatIsOnlyNearlyTheSameWasNotMadeSo)
{
  const auto roughened = [](Surface mesh) {
    mesh = splitOften(mesh);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<float> off(-0.004F, 0.004F); // within the tolerance, 0.006
    for (Vector3& p : mesh.points) {
      p = p + Vector3{off(random), off(random), off(random)};
    }
    return mesh;
  };
  Surface chair = chairOfBoxes();
  EXPECT_FALSE(planesOf(roughened(chair)).empty());
  addBox(chair, {0.3F, -0.25F, 0.4F}, {0.7F, 0.2F, 0.45F});
  EXPECT_TRUE(planesOf(roughened(chair)).empty());
}

TEST(FindMirrorPlanes, FindsNoneOfABodyInAPose)
{
  EXPECT_TRUE(planesOf(bentHuman().surface).empty());
}

TEST(FindMirrorPlanes, FindsAllThreeOfAnEllipsoid)
{
  const std::vector<MirrorFit> planes = planesOf(turned(scaled(sphereMesh(4), {1.0F, 0.7F, 0.4F})));
  ASSERT_EQ(planes.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_GT(planes[a].share, 0.99F);
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NEAR(dot(planes[a].plane.normal, planes[b].plane.normal), 0.0F, 0.02F);
    }
  }
}

TEST(FindMirrorPlanes, ASheetIsNoMirrorImageInItsOwnPlane)
{
  Surface sheet = gridMesh(40, 25);
  for (Vector3& p : sheet.points) {
    p[0] += 0.2F * p[1]; // a parallelogram has no mirror plane but its own
  }
  for (const MirrorFit& fit : planesOf(sheet)) {
    EXPECT_TRUE(fit.is_of_part) << "of all but two corners";
    EXPECT_LT(std::abs(fit.plane.normal[2]), 0.1F);
  }
}

void
expectEqualPlanes(const Surface& mesh, std::size_t count)
{
  const std::vector<MirrorFit> planes = planesOf(mesh);
  EXPECT_EQ(std::count_if(planes.begin(), planes.end(), [](const MirrorFit& fit) { return fit.is_equal; }),
            static_cast<std::ptrdiff_t>(count));
  for (const MirrorFit& fit : planes) {
    EXPECT_TRUE(!fit.is_equal || fit.share > 0.99F) << fit.share;
  }
}

TEST(FindMirrorPlanes, FindsAllOfASquareInAnyPosition)
{
  expectEqualPlanes(gridMesh(25, 25), 4U);
  expectEqualPlanes(turned(gridMesh(25, 25)), 4U);
}

TEST(FindMirrorPlanes, FindsAllNineOfACube)
{
  Surface cube;
  addBox(cube, {0, 0, 0}, {1, 1, 1});
  for (const Surface& mesh : {splitOften(cube), turned(splitOften(cube))}) {
    expectEqualPlanes(mesh, 9U);
  }
}

TEST(FindMirrorPlanes, OfEqualOnesThePlaneAcrossWhatIsLongIsTheFirst)
{
  for (const Vector3& sides : {Vector3{1.5F, 1.0F, 1.2F}, Vector3{1.0F, 1.5F, 1.2F}, Vector3{1.0F, 1.2F, 1.5F}}) {
    Surface box;
    addBox(box, {0, 0, 0}, sides);
    const std::vector<MirrorFit> planes = planesOf(splitOften(box));
    ASSERT_EQ(planes.size(), 3U);
    const auto longest = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    EXPECT_GT(std::abs(planes[0].plane.normal[longest]), 0.999F);
  }
}

TEST(FindMirrorPlanes, WhatIsFittedOnMakesAPlaneWorse)
{
  Surface box;
  addBox(box, {0, 0, 0}, {1.0F, 1.2F, 1.5F});
  Surface handled = splitOften(box);
  Surface knob;
  addBox(knob, {0.4F, 0.55F, 1.52F}, {0.6F, 0.65F, 1.7F}); // on top: two planes are left
  knob = splitOften(knob);
  const auto first = static_cast<Index>(handled.size());
  handled.points.insert(handled.points.end(), knob.points.begin(), knob.points.end());
  for (const Triangle& t : knob.triangles) {
    handled.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  expectEqualPlanes(handled, 2U);
}

} // namespace
