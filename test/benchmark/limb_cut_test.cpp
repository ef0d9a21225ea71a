#include "benchmark/limb_cut.h"
#include "geodesic/surface_graph.h"
#include "model/articulated_body.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <algorithm>
#include <set>

namespace pcl {
namespace symmetry {
namespace {

const Model&
human()
{
  static const Model model = [] {
    ModelParameters parameters;
    parameters.vertices = 3000;
    parameters.bend = 0.0;
    return makeModel(parameters);
  }();
  return model;
}

GroundTruth
truthOf(const Model& model)
{
  GroundTruth truth;
  for (std::size_t v = 0; v < model.partners.size(); ++v)
    if (model.partners[v] != no_index)
      truth.push_back({static_cast<Index>(v), model.partners[v]});
  return truth;
}

std::size_t
openEdges(const Surface& surface)
{
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace(t[k], t[(k + 1) % 3]);
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return edges.count({edge.second, edge.first}) == 0;
  }));
}

TEST(CutLimb, TakesOneArmOrLegAndClosesTheStump)
{
  for (const Limb limb : {Limb::Farthest, Limb::Other}) {
    const DisturbedSurface rest = cutLimb(human().surface, truthOf(human()), limb, Stump::Closed);
    EXPECT_LT(rest.surface.size(), human().surface.size() * 97 / 100);
    EXPECT_GT(rest.surface.size(), human().surface.size() * 7 / 10);
    EXPECT_EQ(openEdges(rest.surface), 0U);
    EXPECT_EQ(connectedComponents(buildMeshGraph(rest.surface.points, rest.surface.triangles)).sizes.size(), 1U);
    ASSERT_EQ(rest.origins.size(), rest.surface.size());
    const auto added = static_cast<std::size_t>(std::count(rest.origins.begin(), rest.origins.end(), no_index));
    EXPECT_GE(added, 1U);
    EXPECT_LE(added, 2U);
    for (std::size_t v = 0; v + added < rest.origins.size(); ++v)
      EXPECT_EQ(rest.surface.points[v], human().surface.points[rest.origins[v]]);
  }
}

/** Mean height of the points that are gone; the hands of the human are at 1.1, the feet at 0. */
float
heightOfLost(Limb limb)
{
  const std::vector<Vector3>& points = human().surface.points;
  const DisturbedSurface rest = cutLimb(human().surface, truthOf(human()), limb, Stump::Open);
  std::vector<char> is_lost(points.size(), 1);
  for (const Index origin : rest.origins)
    is_lost[origin] = 0;
  float sum = 0.0F;
  float count = 0.0F;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_lost[v] != 0) {
      sum += points[v][1];
      count += 1.0F;
    }
  return sum / count;
}

TEST(CutLimb, TakesALegAndAnArm)
{
  EXPECT_LT(heightOfLost(Limb::Farthest), 0.6F) << "the feet are farther apart than the hands";
  EXPECT_GT(heightOfLost(Limb::Other), 0.9F);
}

TEST(CutLimb, LeavesTheStumpOpenWhereThatIsAskedFor)
{
  const DisturbedSurface rest = cutLimb(human().surface, truthOf(human()), Limb::Farthest, Stump::Open);
  EXPECT_GT(openEdges(rest.surface), 5U);
  EXPECT_EQ(std::count(rest.origins.begin(), rest.origins.end(), no_index), 0);
}

TEST(CutLimb, RefusesABodyWithoutLimbs)
{
  const Surface sphere = test::sphereMesh(3);
  EXPECT_THROW(cutLimb(sphere, {}, Limb::Farthest, Stump::Closed), pcl::BadArgumentException);
  EXPECT_THROW(cutLimb(sphere, {{0, 1}, {1, 0}}, Limb::Other, Stump::Closed), pcl::BadArgumentException);
}

} // namespace
} // namespace symmetry
} // namespace pcl
