#include "cloud/clouds.h"
#include "symmetry/interpretations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

/** What a search that finds little makes of a surface. */
Interpretation
unsettled(InterpretationPlan::Attempt attempt, float known_holes = 0.0F)
{
  Interpretation interpretation;
  interpretation.surface = std::move(attempt.surface);
  interpretation.estimate.partners.assign(interpretation.surface.size(), 0);
  interpretation.estimate.map_confidence = 0.1F;
  interpretation.estimate.trust = 0.1F;
  interpretation.estimate.known_holes = known_holes;
  return interpretation;
}

/** How a surface that stays in doubt is understood in turn. */
struct Attempts {
  std::vector<bool> is_cloud;
  std::vector<float> samples;
};

NeighbourLists
search(const std::vector<Vector3>& points, int k)
{
  return test::nearestNeighbours(points, k);
}

Attempts
attemptsOf(const Surface& surface, float known_holes)
{
  const SymmetryParameters parameters;
  const NeighbourSearch neighbours = search;
  InterpretationPlan plan(surface, parameters, neighbours);
  EXPECT_EQ(plan.pooling(), surface.hasFaces() ? Pooling::Odds : Pooling::Votes);
  RivalInterpretations rivals(plan.pooling());
  Attempts attempts;
  while (std::optional<InterpretationPlan::Attempt> attempt = plan.next(rivals)) {
    attempts.is_cloud.push_back(attempt->surface.is_cloud);
    attempts.samples.push_back(attempt->samples);
    rivals.add(unsettled(std::move(*attempt), known_holes));
  }
  return attempts;
}

TEST(InterpretationPlan, AMeshInDoubtIsSampledOtherwise)
{
  const Attempts attempts = attemptsOf(octahedron(), 0.0F);
  ASSERT_EQ(attempts.samples.size(), 3U);
  EXPECT_EQ(attempts.samples[0], 1.0F);
  EXPECT_LT(attempts.samples[1], 0.8F);
  EXPECT_GT(attempts.samples[2], 1.2F);
  EXPECT_EQ(std::count(attempts.is_cloud.begin(), attempts.is_cloud.end(), true), 0) << "its points are few";
}

TEST(InterpretationPlan, AMeshInDoubtWithHolesIsReadAsACloudFirst)
{
  const Attempts attempts = attemptsOf(octahedron(), 0.5F);
  ASSERT_GE(attempts.is_cloud.size(), 4U);
  EXPECT_LE(attempts.is_cloud.size(), 7U);
  EXPECT_FALSE(attempts.is_cloud[0]);
  EXPECT_TRUE(attempts.is_cloud[1]);
  EXPECT_FALSE(attempts.is_cloud.back());
  EXPECT_GT(attempts.samples.back(), 1.2F);
}

TEST(InterpretationPlan, ACloudOfNoSizeIsNotReadWithDepthsOfSpacings)
{
  // Directions evenly spread, distances from the centre of one size, or of a thousand million.
  const auto attemptsAtDistances = [](float decades) {
    Surface cloud;
    constexpr int points = 1500;
    for (int i = 0; i < points; ++i) {
      const float z = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / points;
      const float across = std::sqrt(1.0F - z * z);
      const float angle = 2.399963F * static_cast<float>(i);
      const float r = std::pow(10.0F, -decades * static_cast<float>(i * 7 % points) / points);
      cloud.points.push_back({r * across * std::cos(angle), r * across * std::sin(angle), r * z});
    }
    return attemptsOf(cloud, 0.0F).samples.size();
  };
  EXPECT_GE(attemptsAtDistances(0.0F), 4U);
  EXPECT_LE(attemptsAtDistances(9.0F), 3U);
}

TEST(InterpretationPlan, NothingIsTriedAfterWhatIsBeyondDoubt)
{
  const Surface surface = octahedron();
  const SymmetryParameters parameters;
  const NeighbourSearch neighbours = search;
  InterpretationPlan plan(surface, parameters, neighbours);
  RivalInterpretations rivals(plan.pooling());
  Interpretation sure = unsettled(*plan.next(rivals));
  sure.estimate.status = SymmetryStatus::Symmetric;
  sure.estimate.trust = 0.99F;
  sure.estimate.partners = {1, 0, 2, 3, 4, 5};
  rivals.add(std::move(sure));
  EXPECT_FALSE(plan.next(rivals).has_value());
}

TEST(InterpretationPlan, TheStagedMethodTakesASurfaceAsItIs)
{
  const Surface surface = octahedron();
  SymmetryParameters parameters;
  parameters.method = Method::Staged;
  const NeighbourSearch neighbours = search;
  InterpretationPlan plan(surface, parameters, neighbours);
  EXPECT_EQ(plan.pooling(), Pooling::Votes);
  RivalInterpretations rivals(plan.pooling());
  rivals.add(unsettled(*plan.next(rivals)));
  EXPECT_FALSE(plan.next(rivals).has_value());
}

} // namespace
