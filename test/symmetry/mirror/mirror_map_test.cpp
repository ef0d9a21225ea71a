#include "support/boxes.h"
#include "support/graphs.h"
#include "support/with_threads.h"
#include "symmetry/mirror/mirror_map.h"
#include "symmetry/surface/mesh_cleaning.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

PreparedSurface
inParts(const Surface& mesh)
{
  PreparedSurface surface;
  surface.points = mesh.points;
  surface.triangles = mesh.triangles;
  surface.normals = vertexNormals(mesh.points, mesh.triangles);
  surface.graph = meshGraph(mesh);
  surface.part_of = connectedComponents(surface.graph).component_of;
  return surface;
}

PreparedSurface
chair()
{
  return inParts(chairOfBoxes());
}

TEST(MapByMirror, KeepsAPartTogetherWhereAnotherPartIsNearer)
{
  Surface mesh;
  addBox(mesh, {-0.3F, 0.0F, 0.0F}, {-0.2F, 0.1F, 0.4F});
  addBox(mesh, {0.204F, 0.0F, 0.0F}, {0.304F, 0.1F, 0.4F}); // its twin, a little off
  addBox(mesh, {0.3F, 0.1F, 0.4F}, {0.5F, 0.3F, 0.5F});     // with a corner where one of the first box should be
  const PreparedSurface surface = inParts(mesh);
  const MirrorMap map = mapByMirror(surface, {{1, 0, 0}, 0.0F}, 0.01F, 0.05F);
  for (std::size_t v = 0; v < 8; ++v) {
    ASSERT_NE(map.partners[v], no_index);
    EXPECT_EQ(surface.part_of[map.partners[v]], surface.part_of[8]) << v;
  }
}

TEST(MapByMirror, SendsEveryCornerToItsImageOnTheTwinPart)
{
  const PreparedSurface surface = chair();
  const MirrorMap map = mapByMirror(surface, {{1, 0, 0}, 0.0F}, 0.01F, 0.05F);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    ASSERT_NE(map.partners[v], no_index);
    const Vector3& p = surface.points[v];
    EXPECT_LT(distance(surface.points[map.partners[v]], {-p[0], p[1], p[2]}), 1e-6F) << v;
    EXPECT_EQ(map.partners[map.partners[v]], static_cast<Index>(v));
    EXPECT_LT(map.gaps[v], 1e-6F);
  }
}

TEST(MapByMirror, LeavesOutWhatHasNothingInItsPlace)
{
  PreparedSurface surface = chair();
  for (Vector3& p : surface.points) {
    p[0] += p[0] < -0.22F && p[2] > 0.6F ? -0.2F : 0.0F; // the upper end of one arm rest and of the back
  }
  const MirrorMap map = mapByMirror(surface, {{1, 0, 0}, 0.0F}, 0.01F, 0.05F);
  std::size_t left_out = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    left_out += map.partners[v] == no_index ? 1U : 0U;
    EXPECT_EQ(map.partners[v] == no_index, map.gaps[v] == 0.05F);
  }
  EXPECT_GT(left_out, 8U);
  EXPECT_LT(left_out, surface.size() / 2);
}

TEST(MapByMirror, IsTheSameForAnyNumberOfThreads)
{
  const PreparedSurface surface = chair();
  const PlaneReflection plane{normalized({1.0F, 0.1F, 0.0F}), 0.01F};
  EXPECT_EQ(mapByMirror(surface, plane, 0.05F, 0.1F).partners,
            withThreads(3, [&] { return mapByMirror(surface, plane, 0.05F, 0.1F); }).partners);
}

} // namespace
