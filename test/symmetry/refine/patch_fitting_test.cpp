#include "support/sample_partners.h"
#include "support/with_threads.h"
#include "symmetry/refine/patch_fitting.h"
#include "symmetry/refine/reflection_growth.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** The extremity that the true map moves farthest. */
Index
tipOfLimb(const CoarseBody& body)
{
  const SampleMap truth = body.trueMap();
  Index best = body.landmarks.extremities.front();
  for (const Index tip : body.landmarks.extremities) {
    if (body.landmarks.distances(tip, truth[tip]) > body.landmarks.distances(best, truth[best])) {
      best = tip;
    }
  }
  return best;
}

/** The true partners, but those of a limb's end are all in one place of the trunk. */
std::vector<Index>
withLostEnd(const CoarseBody& body, const SurfacePatch& end)
{
  std::vector<Index> partners = truePartners(body);
  Eigen::Index middle = 0;
  body.landmarks.distances.rowwise().maxCoeff().minCoeff(&middle);
  for (const PatchMember& member : end) {
    partners[member.sample] = body.coarse.cells.vertices[static_cast<std::size_t>(middle)];
  }
  return partners;
}

RigidReflection
moved(const RigidReflection& reflection, const Vector3& about, float angle, float shift)
{
  const Eigen::Vector3f c(about[0], about[1], about[2]);
  const Eigen::Matrix3f turn = Eigen::AngleAxisf(angle, Eigen::Vector3f(0.6F, 0.0F, 0.8F)).toRotationMatrix();
  RigidReflection result;
  result.linear = turn * reflection.linear;
  result.shift = turn * (reflection.shift - c) + c + Eigen::Vector3f(shift, 0.0F, 0.0F);
  return result;
}

TEST(PatchFitting, TheTrueMapFitsAndAnotherDoesNot)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  const float radius = 0.1F * body.landmarks.diameter;
  const std::vector<Index> truth = truePartners(body);
  const std::vector<Index>& identity = body.coarse.cells.vertices;
  std::size_t fits = 0;
  std::size_t others = 0;
  for (Index centre = 0; centre < 100; ++centre) {
    const SurfacePatch patch = patchAround(body.coarse, centre, radius);
    fits += fitting.settled(patch, fitting.byMap(patch, body.surface, truth)).misfit < 0.1F ? 1U : 0U;
    others += fitting.settled(patch, moved(RigidReflection{}, {}, 1.0F, 0.1F)).misfit < 0.1F ? 1U : 0U;
    EXPECT_LE(fitting.settled(patch, fitting.byMap(patch, body.surface, identity)).misfit, 1.0F);
  }
  EXPECT_GT(fits, 90U);
  EXPECT_LT(others, 10U);
}

TEST(PatchFitting, FindsBackFromNearby)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  const SurfacePatch head = patchAround(body.coarse, tipOfLimb(body), 0.12F * body.landmarks.diameter);
  const RigidReflection by_map = fitting.byMap(head, body.surface, truePartners(body));
  const Vector3 image = by_map(body.coarse.points[head.front().sample]);
  const PatchPlacement there = fitting.settled(head, by_map);
  const PatchPlacement back = fitting.settled(head, moved(by_map, image, 0.2F, 0.5F * fitting.spacing()));
  EXPECT_LT(there.misfit, 0.1F);
  EXPECT_LT(back.misfit, 1.5F * there.misfit + 0.02F);
  EXPECT_LT(distance(back.reflection(body.coarse.points[head.front().sample]), image), fitting.spacing());
}

TEST(PatchFitting, NothingIsFarAway)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  const SurfacePatch patch = patchAround(body.coarse, 0, 0.1F * body.landmarks.diameter);
  RigidReflection away;
  away.shift = Eigen::Vector3f(50.0F, 0.0F, 0.0F);
  EXPECT_EQ(fitting.nearestFacing({50.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}), no_index);
  EXPECT_EQ(fitting.settled(patch, away).misfit, 1.0F);
  for (Index i = 0; i < 20; ++i) {
    EXPECT_EQ(fitting.nearestFacing(body.coarse.points[i], body.coarse.normals[i]), i);
  }
}

TEST(GrowReflections, BringsALostEndOfALimbBack)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  const SurfacePatch end = patchAround(body.coarse, tipOfLimb(body), 0.12F * body.landmarks.diameter);
  const std::vector<Index> lost = withLostEnd(body, end);
  const GrowthSettings settings;
  std::vector<Index> partners = lost;
  EXPECT_GT(growReflections(body.sampled(), fitting, settings, partners), 0U);
  const std::vector<Index> truth = truePartners(body);
  std::size_t near = 0;
  for (const PatchMember& member : end) {
    const Index partner = partners[member.sample];
    near += distance(body.surface.points[partner], body.surface.points[truth[member.sample]]) < 2.0F * fitting.spacing()
                ? 1U
                : 0U;
  }
  EXPECT_GT(near, 9 * end.size() / 10);
  EXPECT_LT(errorOf(body, partners), 0.3F * errorOf(body, lost));

  std::vector<Index> in_threads = lost;
  withThreads(5, [&] { return growReflections(body.sampled(), fitting, settings, in_threads); });
  EXPECT_EQ(partners, in_threads);
}

TEST(GrowReflections, LeavesTheTrueMapInPlace)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  std::vector<Index> partners = truePartners(body);
  growReflections(body.sampled(), fitting, GrowthSettings{}, partners);
  EXPECT_LT(errorOf(body, partners), 0.15F);
}

TEST(GrowReflections, NothingGrowsWithoutPatches)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  const SurfacePatch end = patchAround(body.coarse, tipOfLimb(body), 0.12F * body.landmarks.diameter);
  const std::vector<Index> lost = withLostEnd(body, end);
  std::vector<Index> partners = lost;
  GrowthSettings settings;
  settings.patches = 0;
  EXPECT_EQ(growReflections(body.sampled(), fitting, settings, partners), 0U);
  EXPECT_EQ(partners, lost);
}

} // namespace
