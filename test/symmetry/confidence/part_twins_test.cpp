#include "support/boxes.h"
#include "support/graphs.h"
#include "symmetry/confidence/part_twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A seat and two legs of a fifth of its length. */
PreparedSurface
stool()
{
  Surface mesh;
  addBox(mesh, {-0.5F, -0.5F, 0.4F}, {0.5F, 0.5F, 0.5F});
  addBox(mesh, {-0.4F, 0.0F, 0.0F}, {-0.3F, 0.1F, 0.4F});
  addBox(mesh, {0.3F, 0.0F, 0.0F}, {0.4F, 0.1F, 0.4F});
  PreparedSurface surface;
  surface.points = mesh.points;
  surface.triangles = mesh.triangles;
  surface.graph = meshGraph(mesh);
  surface.part_of = connectedComponents(surface.graph).component_of;
  return surface;
}

/** Partners that exchange two parts of eight corners, all others go to themselves. */
std::vector<Index>
exchanged(Index a, Index b)
{
  std::vector<Index> partners(24);
  std::iota(partners.begin(), partners.end(), 0);
  for (Index corner = 0; corner < 8; ++corner) {
    std::swap(partners[8 * a + corner], partners[8 * b + corner]);
  }
  return partners;
}

TEST(ShareOfTwinParts, IsOneWherePartsGoToTheirLike)
{
  EXPECT_NEAR(shareOfTwinParts(stool(), exchanged(1, 2)), 1.0F, 1e-5F);
  EXPECT_NEAR(shareOfTwinParts(stool(), exchanged(0, 0)), 1.0F, 1e-5F);
}

TEST(ShareOfTwinParts, IsSmallWhereASeatGoesToALeg)
{
  EXPECT_LT(shareOfTwinParts(stool(), exchanged(0, 1)), 0.2F);
}

TEST(ShareOfTwinParts, DoesNotCountWhatGoesNowhere)
{
  std::vector<Index> partners = exchanged(1, 2);
  std::fill(partners.begin() + 8, partners.end(), no_index); // the legs: 0.36 of 2.76
  EXPECT_NEAR(shareOfTwinParts(stool(), partners), 2.4F / 2.76F, 0.01F);
}

TEST(ShareOfTwinParts, OfOnePartIsOne)
{
  PreparedSurface one = stool();
  one.part_of.clear();
  EXPECT_EQ(shareOfTwinParts(one, exchanged(0, 1)), 1.0F);
}

} // namespace
