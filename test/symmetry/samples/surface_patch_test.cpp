#include "geodesic/shortest_paths.h"
#include "support/graphs.h"
#include "symmetry/samples/surface_patch.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(SurfacePatch, HoldsWhatIsNearerThanTheRadiusWeightedByDistance)
{
  CoarseSurface coarse;
  coarse.graph = randomGraph(200, 6, evenLength);
  coarse.points.resize(coarse.graph.size());
  for (const Index centre : {Index{0}, Index{77}}) {
    const std::vector<float> field = distanceField(coarse.graph, centre);
    for (const float radius : {0.1F, 0.7F, 100.0F}) {
      const SurfacePatch patch = patchAround(coarse, centre, radius);
      std::size_t member = 0;
      for (std::size_t i = 0; i < coarse.size(); ++i) {
        if (field[i] >= radius) {
          continue;
        }
        ASSERT_LT(member, patch.size());
        EXPECT_EQ(patch[member].sample, static_cast<Index>(i)); // the lowest first
        const float share = field[i] / radius;
        EXPECT_FLOAT_EQ(patch[member].weight, (1.0F - share * share) * (1.0F - share * share));
        ++member;
      }
      EXPECT_EQ(member, patch.size());
    }
  }
}

TEST(SurfacePatch, WithoutARadiusToSpeakOfIsItsCentre)
{
  CoarseSurface coarse;
  coarse.graph = meshGraph(gridMesh(5, 5));
  coarse.points.resize(25);
  const SurfacePatch patch = patchAround(coarse, 12, 0.5F);
  ASSERT_EQ(patch.size(), 1U);
  EXPECT_EQ(patch[0].sample, 12);
  EXPECT_EQ(patch[0].weight, 1.0F);
}

} // namespace
