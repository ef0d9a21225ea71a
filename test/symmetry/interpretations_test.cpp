#include "symmetry/interpretations.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(PastInterpretations, AreThoseOfTheSamePointsWithTheSameContacts)
{
  const ContactTest trusting{0.5F, 3.0F, 0.0F};
  PreparedSurface surface;
  surface.points = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}};
  PastInterpretations past;
  EXPECT_TRUE(past.isNew(surface, trusting));
  EXPECT_FALSE(past.isNew(surface, trusting));
  EXPECT_TRUE(past.isNew(surface, {0.5F, 3.0F, 1.0F}));
  EXPECT_TRUE(past.isNew(surface, {0.5F, 4.0F, 0.0F}));
  EXPECT_TRUE(past.isNew(surface, {0.8F, 3.0F, 0.0F}));
  EXPECT_TRUE(past.isNew(surface, {0.5F, 3.0F, 0.0F, true}));

  PreparedSurface parted = surface;
  parted.normals = {{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}};
  EXPECT_TRUE(past.isNew(parted, trusting));
  parted.points[1] = {2.0F, 0.0F, 0.0F};
  EXPECT_TRUE(past.isNew(parted, trusting));
  EXPECT_FALSE(past.isNew(parted, trusting));
  EXPECT_FALSE(past.isNew(surface, trusting)) << "is remembered after others";
}

/** An octahedron: enough for a plan, which does not look for symmetries itself. */
Surface
octahedron()
{
  Surface surface;
  surface.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  surface.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return surface;
}

Interpretation
unsettled(PreparedSurface surface, float known_holes)
{
  Interpretation interpretation;
  interpretation.surface = std::move(surface);
  interpretation.estimate.known_holes = known_holes;
  return interpretation;
}

TEST(InterpretationPlan, AMeshWithoutHolesIsTakenAsItIs)
{
  const Surface surface = octahedron();
  const SymmetryParameters parameters;
  const NeighbourSearch search;
  InterpretationPlan plan(surface, parameters, search);
  RivalInterpretations rivals;
  std::optional<PreparedSurface> first = plan.next(rivals);
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE(first->is_cloud);
  EXPECT_EQ(first->size(), surface.size());
  rivals.add(unsettled(std::move(*first), 0.0F));
  EXPECT_FALSE(plan.next(rivals).has_value());
  EXPECT_FALSE(plan.next(rivals).has_value());
}

TEST(InterpretationPlan, NothingIsTriedAfterWhatIsBeyondDoubt)
{
  const Surface surface = octahedron();
  const SymmetryParameters parameters;
  const NeighbourSearch search;
  InterpretationPlan plan(surface, parameters, search);
  RivalInterpretations rivals;
  Interpretation sure = unsettled(*plan.next(rivals), 0.5F);
  sure.estimate.status = SymmetryStatus::Symmetric;
  sure.estimate.confidence = 0.99F;
  sure.estimate.partners = {1, 0, 2, 3, 4, 5};
  rivals.add(std::move(sure));
  EXPECT_FALSE(plan.next(rivals).has_value());
}

} // namespace
