// Limbs without a counterpart: the rest is mapped without them.
#include "base/vector_math.h"
#include "support/known_body.h"
#include "support/prepared.h"
#include "symmetry/odd_limb.h"
#include "symmetry/robust_method.h"
#include "symmetry/surface/limb.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

Model
creature(Body kind, std::uint64_t seed, double bend = 1.0)
{
  return body(kind, bend, seed, 7000);
}

/** A surface as it is understood at first. */
Interpretation
understood(const Surface& mesh)
{
  Interpretation first;
  first.surface = preparedMesh(mesh);
  StepTimer timer;
  first.estimate = estimateRobust(first.surface, SymmetryParameters{}, robustSettings(SymmetryParameters{}), timer);
  return first;
}

std::optional<Interpretation>
withoutOddLimb(const Interpretation& first)
{
  StepTimer timer;
  return mapWithoutOddLimb(first, SymmetryParameters{}, timer);
}

/** Share of the points of the creature with a partner near the mirror image in the rest pose, among those that have one. */
double
shareRight(const Surface& rest, const std::vector<Index>& partners)
{
  std::size_t mapped = 0;
  std::size_t right = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (partners[v] != no_index) {
      const Vector3& p = rest.points[v];
      ++mapped;
      right += distance(rest.points[static_cast<std::size_t>(partners[v])], {-p[0], p[1], p[2]}) < 0.15F ? 1U : 0U;
    }
  }
  return static_cast<double>(right) / static_cast<double>(mapped);
}

TEST(OddLimb, IsCutOffAndTheRestIsMapped)
{
  for (const std::uint64_t seed : {114U, 117U, 123U}) { // right but in doubt, head to tail, right but for the hip
    const Interpretation first = understood(creature(Body::LameCreature, seed).surface);
    const std::optional<Interpretation> found = withoutOddLimb(first);
    ASSERT_TRUE(found) << seed;
    const MapEstimate& estimate = found->estimate;
    EXPECT_EQ(estimate.status, SymmetryStatus::PartlySymmetric) << seed;
    EXPECT_TRUE(estimate.is_partial);
    EXPECT_LT(estimate.misfit, first.estimate.misfit);
    const Surface rest = creature(Body::LameCreature, seed, 0.0).surface;
    EXPECT_GT(shareRight(rest, estimate.partners), 0.97) << seed;
    std::size_t left_out = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const bool is_out = estimate.is_unsupported[v] != 0;
      left_out += is_out ? 1U : 0U;
      EXPECT_EQ(is_out, estimate.partners[v] == no_index) << v;
      EXPECT_TRUE(!is_out || (estimate.support[v] == 0.0F && estimate.confidences[v] == 0.0F)) << v;
    }
    EXPECT_NEAR(static_cast<double>(left_out) / static_cast<double>(rest.size()), estimate.unsupported_share, 0.03);
    for (const SymmetricMatch& match : estimate.matches) {
      EXPECT_EQ(estimate.is_unsupported[static_cast<std::size_t>(match.source)], 0);
      EXPECT_EQ(estimate.is_unsupported[static_cast<std::size_t>(match.target)], 0);
    }
  }
}

/** The whole fits as well, but for one place. */
TEST(OddLimb, IsOneWhereTheRestIsSureAndTheWholeIsNot)
{
  Interpretation first = understood(creature(Body::LameCreature, 515).surface);
  ASSERT_LT(first.estimate.map_confidence, 0.5F);
  first.estimate.misfit -= 0.5F; // as with other numbers of samples, or where the odd limb has no end
  const std::optional<Interpretation> found = withoutOddLimb(first);
  ASSERT_TRUE(found);
  EXPECT_GT(found->estimate.confidence, 0.9F);
  EXPECT_GT(found->estimate.misfit, first.estimate.misfit);
  EXPECT_GT(shareRight(creature(Body::LameCreature, 515, 0.0).surface, found->estimate.partners), 0.97);
}

/** The rest is sure enough by itself, but explains less. */
TEST(OddLimb, IsNoneWhereTheMapSoFarFitsBetter)
{
  Interpretation first = understood(creature(Body::LameCreature, 123).surface);
  first.estimate.misfit = -20.0F;
  first.estimate.confidence = 0.7F;
  for (const SymmetryStatus status : {SymmetryStatus::PartlySymmetric, SymmetryStatus::Symmetric}) {
    first.estimate.status = status;
    EXPECT_FALSE(withoutOddLimb(first));
  }
}

TEST(OddLimb, IsNotLookedForWhereNothingIsInDoubt)
{
  Interpretation first = understood(creature(Body::LameCreature, 123).surface);
  first.estimate.status = SymmetryStatus::Symmetric;
  first.estimate.confidence = 0.8F;
  EXPECT_FALSE(withoutOddLimb(first));
}

TEST(OddLimb, IsNotLookedForInAnObjectInParts)
{
  Interpretation first = understood(creature(Body::LameCreature, 123).surface);
  first.surface.part_of.assign(first.surface.size(), 0);
  EXPECT_FALSE(withoutOddLimb(first));
}

/** However little a right map is trusted: without a limb nothing fits better. */
TEST(OddLimb, IsNoneOfAWholeCreature)
{
  for (const std::uint64_t seed : {101U, 105U}) {
    Interpretation first = understood(creature(Body::Creature, seed).surface);
    ASSERT_EQ(first.estimate.status, SymmetryStatus::Symmetric);
    first.estimate.confidence = 0.5F;
    EXPECT_FALSE(withoutOddLimb(first)) << seed;
  }
}

/** Without one of a pair the same map is found for the rest, which by itself says nothing. */
TEST(OddLimb, IsNoneThatTheSameMapPairsWithAnother)
{
  for (const std::uint64_t seed : {107U, 111U}) {
    Interpretation first = understood(creature(Body::Creature, seed).surface);
    ASSERT_EQ(first.estimate.status, SymmetryStatus::Symmetric);
    first.estimate.status = SymmetryStatus::NoSymmetry;
    first.estimate.misfit = 0.0F;
    EXPECT_FALSE(withoutOddLimb(first)) << seed;
  }
}

/** Share of the points that lie far from the mirror image in the rest pose. */
float
shareOdd(const Surface& rest)
{
  std::size_t odd = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    odd += distanceFromMirrorImage(rest, static_cast<Index>(v)) > 0.06F ? 1U : 0U;
  }
  return static_cast<float>(odd) / static_cast<float>(rest.size());
}

/** What was cut off of the trunk comes back, and nothing of the limb. */
TEST(OddLimb, IsGivenBackWhatWasCutTooDeep)
{
  const std::uint64_t seed = 123;
  const Interpretation first = understood(creature(Body::LameCreature, seed).surface);
  const std::optional<Interpretation> found = withoutOddLimb(first);
  ASSERT_TRUE(found);
  std::optional<Limb> limb;
  for (const Index end : first.estimate.ends) {
    limb =
        found->estimate.is_unsupported[static_cast<std::size_t>(end)] != 0 ? findLimb(first.surface, end, 1500) : limb;
  }
  ASSERT_TRUE(limb);
  limb->root *= 1.3F;
  StepTimer timer;
  std::optional<MapEstimate> estimate = mapWithoutLimb({*limb}, first, SymmetryParameters{}, timer);
  ASSERT_TRUE(estimate);
  const float odd = shareOdd(creature(Body::LameCreature, seed, 0.0).surface);
  EXPECT_GT(estimate->unsupported_share, 1.4F * odd);
  giveBack({*limb}, first, SymmetryParameters{}, timer, *estimate);
  EXPECT_LT(estimate->unsupported_share, 1.2F * odd);
  EXPECT_GT(estimate->unsupported_share, 0.8F * odd);
}

/** What is left is its own mirror image as it stands: a plane maps it, which knows of no landmarks. */
TEST(OddLimb, OfACreatureThatStandsStraight)
{
  const Surface standing = creature(Body::LameCreature, 104, 0.0).surface;
  Interpretation first = understood(standing);
  first.estimate.ends = understood(creature(Body::LameCreature, 104).surface).estimate.ends;
  first.estimate.is_by_plane = false; // a plane that leaves out the limb maps the whole, too
  first.estimate.misfit = 0.0F;
  first.estimate.status = SymmetryStatus::NoSymmetry;
  const std::optional<Interpretation> found = withoutOddLimb(first);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->estimate.is_by_plane);
  EXPECT_TRUE(found->estimate.landmark_of.empty());
  EXPECT_GT(shareRight(standing, found->estimate.partners), 0.97);
}

TEST(OddLimb, IsNotCutOffWhereTheSearchFindsNothingBetterWithoutIt)
{
  Interpretation first = understood(creature(Body::LameCreature, 114).surface);
  first.estimate.search_score = -10.0F; // no search has a score as good
  EXPECT_FALSE(withoutOddLimb(first));
}

} // namespace
