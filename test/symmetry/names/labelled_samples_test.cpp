#include "support/named_body.h"
#include "symmetry/names/labelled_samples.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<Side>
leftAndRight(const Model& at_rest)
{
  std::vector<Side> sides;
  for (const Vector3& p : at_rest.surface.points) {
    sides.push_back(p[0] > 0.01F ? Side::Source : p[0] < -0.01F ? Side::Target : Side::Axis);
  }
  return sides;
}

TEST(LabelledSamples, HaveTheSidesAndPartnersOfTheirPoints)
{
  const Model model = body(Body::Human, 0.0);
  const ComparableSurface surface =
      describeLabelled(model.surface, leftAndRight(model), model.partners, NeighbourSearch{});
  ASSERT_TRUE(surface.isComparable());
  EXPECT_NEAR(surface.sides.dot(surface.areas), 0.0, 0.05); // both halves are of one size
  EXPECT_GT(surface.sides.cwiseAbs().dot(surface.areas) / surface.areas.sum(), 0.8);
}

TEST(LabelledSamples, OfPointsWithoutPartnersAreLeftOut)
{
  const Model model = body(Body::Human, 0.0);
  std::vector<Index> none(model.partners.size(), no_index);
  EXPECT_FALSE(describeLabelled(model.surface, leftAndRight(model), none, NeighbourSearch{}).isComparable());
  std::vector<Index> upper = model.partners;
  for (std::size_t v = 0; v < upper.size(); ++v) {
    upper[v] = model.surface.points[v][2] < 0.0F ? no_index : upper[v];
  }
  EXPECT_TRUE(describeLabelled(model.surface, leftAndRight(model), upper, NeighbourSearch{}).isComparable());
}

} // namespace
