// Local change of distances, support, and the parts that are left out.
#include "support/coarse_body.h"
#include "support/human.h"
#include "support/with_threads.h"
#include "symmetry/confidence/local_change.h"
#include "symmetry/confidence/support.h"
#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/refine/sample_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** The partner point of every sample. */
std::vector<Index>
truePartners(const CoarseBody& body)
{
  std::vector<Index> partners;
  for (const Index v : body.coarse.cells.vertices) {
    partners.push_back(body.model.partners[v]);
  }
  return partners;
}

SampleEstimate
estimateOf(const CoarseBody& body)
{
  SampleEstimate estimate;
  estimate.partners = truePartners(body);
  estimate.landmark_map = body.trueMap();
  return estimate;
}

/** Sends a landmark, and its sample, to itself. */
void
letStandStill(const CoarseBody& body, std::size_t landmark, SampleEstimate& estimate)
{
  estimate.landmark_map[landmark] = static_cast<Index>(landmark);
  estimate.partners[landmark] = body.coarse.cells.vertices[landmark];
}

/** The landmarks within a geodesic radius (share of the diameter) of one. */
std::vector<char>
around(const CoarseBody& body, Index landmark, float radius)
{
  std::vector<char> marks;
  for (std::size_t i = 0; i < body.landmarks.size(); ++i) {
    marks.push_back(static_cast<char>(body.landmarks.distances(static_cast<Eigen::Index>(i), landmark) <
                                      radius * body.landmarks.diameter));
  }
  return marks;
}

TEST(LocalDistanceChange, IsSmallEverywhereUnderTheTrueMap)
{
  const CoarseBody& body = human();
  const std::vector<float> change = LocalDistanceChange(body.sampled(), truePartners(body)).everywhere();
  ASSERT_EQ(change.size(), body.landmarks.size());
  EXPECT_LT(*std::max_element(change.begin(), change.end()), SupportSettings{}.change);
  EXPECT_EQ(change,
            withThreads(4, [&] { return LocalDistanceChange(body.sampled(), truePartners(body)).everywhere(); }));
}

TEST(LocalDistanceChange, OfTheIdentityIsNone)
{
  const CoarseBody& body = human();
  for (const float change : LocalDistanceChange(body.sampled(), body.coarse.cells.vertices).everywhere()) {
    EXPECT_LT(change, 0.15F); // the points of the samples themselves, but for interpolation
  }
}

TEST(LocalDistanceChange, IsLargeWhereALimbIsSentToItsRoot)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  const std::vector<char> limb = around(body, extremity, 0.15F);
  std::vector<Index> partners = truePartners(body);
  Index root = no_index;
  for (std::size_t i = 0; i < limb.size() && root == no_index; ++i) {
    const float d = body.landmarks.distances(static_cast<Eigen::Index>(i), extremity) / body.landmarks.diameter;
    root = d > 0.2F && d < 0.3F ? body.model.partners[body.coarse.cells.vertices[i]] : no_index;
  }
  ASSERT_NE(root, no_index);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    partners[i] = limb[i] != 0 ? root : partners[i];
  }
  const std::vector<float> change = LocalDistanceChange(body.sampled(), partners).everywhere();
  EXPECT_GT(change[extremity], SupportSettings{}.change);
}

TEST(FindSupport, LeavesNothingOutWhereNothingChanges)
{
  const CoarseBody& body = human();
  const std::vector<float> none(body.landmarks.size(), 0.1F);
  const Support support = findSupport(body.sampled(), estimateOf(body), none);
  EXPECT_EQ(support.unsupported_share, 0.0F);
  EXPECT_EQ(std::count(support.is_unsupported.begin(), support.is_unsupported.end(), 1), 0);
}

TEST(FindSupport, SingleLandmarksAreNoise)
{
  const CoarseBody& body = human();
  std::vector<float> change(body.landmarks.size(), 0.1F);
  change[7] = 5.0F;
  EXPECT_EQ(findSupport(body.sampled(), estimateOf(body), change).unsupported_share, 0.0F);
}

TEST(FindSupport, TakesInWhatIsCutOffAndMirroredInItself)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  const std::vector<char> inner = around(body, extremity, 0.16F);
  const std::vector<char> outer = around(body, extremity, 0.3F);
  SampleEstimate estimate = estimateOf(body);
  std::vector<float> change(body.landmarks.size(), 0.1F);
  for (std::size_t i = 0; i < change.size(); ++i) {
    change[i] = outer[i] != 0 && inner[i] == 0 ? 1.0F : 0.1F; // a ring at the root of a limb
    if (outer[i] != 0) {
      estimate.landmark_map[i] = static_cast<Index>(i); // which stands still
    }
  }
  const Support support = findSupport(body.sampled(), estimate, change);
  EXPECT_EQ(support.is_unsupported[extremity], 1);
  EXPECT_GT(support.unsupported_share, 0.02F);
  EXPECT_LT(support.unsupported_share, 0.3F);

  // The same ring around a limb that has a counterpart takes in nothing but itself.
  estimate.landmark_map = body.trueMap();
  EXPECT_EQ(findSupport(body.sampled(), estimate, change).is_unsupported[extremity], 0);
}

/** The place in the ring around a tip that lies opposite: as far from the tip, and as far from one end of a diameter of the
 * ring as the landmark is from the other. */
Index
oppositeOf(const CoarseBody& body, Index landmark, Index tip, Index one_end, Index other_end)
{
  const Eigen::MatrixXf& d = body.landmarks.distances;
  Index opposite = landmark;
  float best = std::numeric_limits<float>::max();
  for (Eigen::Index j = 0; j < d.cols(); ++j) {
    const float mismatch = std::abs(d(j, tip) - d(landmark, tip)) + std::abs(d(j, other_end) - d(landmark, one_end)) +
                           std::abs(d(j, one_end) - d(landmark, other_end));
    if (mismatch < best) {
      best = mismatch;
      opposite = static_cast<Index>(j);
    }
  }
  return opposite;
}

TEST(FindSupport, ARingIsClosedByTheImagesOfItsOneSide)
{
  const CoarseBody& body = human();
  const Eigen::MatrixXf& d = body.landmarks.distances;
  const Index tip = body.landmarks.extremities.front();
  const std::vector<char> inner = around(body, tip, 0.14F);
  const std::vector<char> outer = around(body, tip, 0.32F);
  std::vector<Index> middle; // of the ring: a circle around the limb
  for (std::size_t i = 0; i < outer.size(); ++i) {
    if (std::abs(d(static_cast<Eigen::Index>(i), tip) / body.landmarks.diameter - 0.23F) < 0.02F) {
      middle.push_back(static_cast<Index>(i));
    }
  }
  ASSERT_GT(middle.size(), 3U);
  const Index one_end = middle.front();
  const Index other_end =
      *std::max_element(middle.begin(), middle.end(), [&](Index a, Index b) { return d(a, one_end) < d(b, one_end); });
  // A limb mirrored in itself, one side going to the other: distances change on one side alone.
  SampleEstimate estimate = estimateOf(body);
  std::vector<float> change(outer.size(), 0.1F);
  for (std::size_t i = 0; i < outer.size(); ++i) {
    if (outer[i] != 0) {
      const auto landmark = static_cast<Index>(i);
      estimate.landmark_map[i] = oppositeOf(body, landmark, tip, one_end, other_end);
      change[i] = inner[i] == 0 && d(landmark, one_end) < d(landmark, other_end) ? 1.0F : 0.1F;
    }
  }
  SupportSettings closer;
  closer.suspects_images = true;
  EXPECT_EQ(findSupport(body.sampled(), estimate, change).is_unsupported[tip], 0) << "half of a ring";
  EXPECT_EQ(findSupport(body.sampled(), estimate, change, closer).is_unsupported[tip], 1);
}

TEST(TakeBackSupported, WhatLiesBeyondWhatIsLeftOutAndIsMirroredInItselfIsLeftOut)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  const std::vector<char> hand = around(body, extremity, 0.1F);
  const std::vector<char> limb = around(body, extremity, 0.25F);
  SampleEstimate estimate = estimateOf(body);
  Support support;
  support.is_unsupported.resize(limb.size(), 0);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    support.is_unsupported[i] = static_cast<char>(limb[i] != 0 && hand[i] == 0);
    if (limb[i] != 0) {
      letStandStill(body, i, estimate);
    }
  }
  support.is_disturbed = support.is_unsupported;
  std::vector<float> changes(limb.size(), 1.0F);
  SupportSettings settings;
  settings.change = 0.0F; // nothing joins by its distances
  EXPECT_EQ(takeBackSupported(body.sampled(), estimate, support, settings, changes).is_unsupported[extremity], 1);
}

TEST(TakeBackSupported, WhatChangesOnlyRelativeToAnOddPartHasACounterpart)
{
  const CoarseBody& body = human();
  Support support;
  support.is_unsupported = around(body, body.landmarks.extremities.front(), 0.3F);
  support.is_disturbed = support.is_unsupported;
  support.unsupported_share = 0.1F;
  std::vector<float> changes(body.landmarks.size(), 1.0F);
  const Support rest = takeBackSupported(body.sampled(), estimateOf(body), support, {}, changes);
  EXPECT_EQ(rest.unsupported_share, 0.0F) << "the map is right there";
  for (std::size_t i = 0; i < changes.size(); ++i) {
    EXPECT_EQ(changes[i] <= SupportSettings{}.change, support.is_unsupported[i] != 0)
        << "measured anew where it joined";
  }
}

TEST(TakeBackSupported, ALimbThatIsSentIntoItselfStaysOut)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  const std::vector<char> limb = around(body, extremity, 0.25F);
  Support support;
  support.is_unsupported = around(body, extremity, 0.35F); // with its root, which has a counterpart
  support.is_disturbed.resize(limb.size(), 0);             // to see what is marked
  SampleEstimate estimate = estimateOf(body);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    if (limb[i] != 0) {
      letStandStill(body, i, estimate);
    }
  }
  std::vector<float> changes(body.landmarks.size(), 1.0F);
  const Support rest = takeBackSupported(body.sampled(), estimate, support, {}, changes);
  EXPECT_EQ(rest.is_unsupported[extremity], 1);
  EXPECT_LT(std::count(rest.is_unsupported.begin(), rest.is_unsupported.end(), 1),
            std::count(support.is_unsupported.begin(), support.is_unsupported.end(), 1));
  EXPECT_GE(std::count(rest.is_unsupported.begin(), rest.is_unsupported.end(), 1),
            std::count(limb.begin(), limb.end(), 1) / 2);
  // A limb stands out, so that what is around its root is disturbed, too; nothing is that is farther away.
  const std::vector<char> wider = around(body, extremity, 0.35F + SupportSettings{}.rim);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    EXPECT_LE(rest.is_unsupported[i], rest.is_disturbed[i]);
    EXPECT_LE(rest.is_disturbed[i], wider[i]);
  }
  EXPECT_GT(std::count(rest.is_disturbed.begin(), rest.is_disturbed.end(), 1),
            std::count(rest.is_unsupported.begin(), rest.is_unsupported.end(), 1));
}

TEST(TakeBackSupported, WhatHasAPartnerThatHasNoneStaysOut)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  const std::vector<char> limb = around(body, extremity, 0.2F);
  SampleEstimate estimate = estimateOf(body);
  std::vector<char> other(limb.size(), 0);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    if (limb[i] != 0) {
      other[body.trueMap()[i]] = 1;
    }
  }
  Support support;
  support.is_unsupported = limb;
  for (std::size_t i = 0; i < limb.size(); ++i) {
    if (other[i] != 0) { // the other limb is sent into itself
      support.is_unsupported[i] = 1;
      letStandStill(body, i, estimate);
    }
  }
  support.is_disturbed = support.is_unsupported;
  std::vector<float> changes(limb.size(), 1.0F);
  const Support rest = takeBackSupported(body.sampled(), estimate, support, {}, changes);
  EXPECT_EQ(rest.is_unsupported[extremity], 1) << "its partner is on a limb that is not supported";
}

TEST(TakeBackSupported, WhatIsExchangedHasACounterpartWhateverItsDistances)
{
  const CoarseBody& body = human();
  const Index extremity = body.landmarks.extremities.front();
  SampleEstimate estimate = estimateOf(body);
  const Index counterpart = estimate.landmark_map[extremity];
  ASSERT_GT(body.landmarks.distances(extremity, counterpart), limb_separation * body.landmarks.diameter);
  Support support;
  support.is_unsupported = around(body, extremity, 0.1F);
  const std::vector<char> other = around(body, counterpart, 0.1F);
  const auto middle = static_cast<Index>(
      std::min_element(body.landmarks.average_distance.begin(), body.landmarks.average_distance.end()) -
      body.landmarks.average_distance.begin());
  for (std::size_t i = 0; i < other.size(); ++i) {
    support.is_unsupported[i] = static_cast<char>(support.is_unsupported[i] != 0 || other[i] != 0);
    if (support.is_unsupported[i] != 0) { // distances are those of another place, as through a contact
      estimate.partners[i] = body.coarse.cells.vertices[middle];
    }
  }
  support.is_disturbed = support.is_unsupported;
  std::vector<float> changes(other.size(), 1.0F);
  const Support rest = takeBackSupported(body.sampled(), estimate, support, {}, changes);
  EXPECT_EQ(rest.is_unsupported[extremity], 0);
  EXPECT_EQ(rest.is_unsupported[counterpart], 0);
  EXPECT_EQ(rest.is_disturbed, support.is_disturbed) << "but it is no evidence for the map";
  estimate.landmark_map[extremity] = extremity;
  EXPECT_EQ(takeBackSupported(body.sampled(), estimate, support, {}, changes).is_unsupported[extremity], 0)
      << "a single landmark is noise";
  for (std::size_t i = 0; i < other.size(); ++i) {
    estimate.landmark_map[i] = support.is_unsupported[i] != 0 ? static_cast<Index>(i) : estimate.landmark_map[i];
  }
  EXPECT_EQ(takeBackSupported(body.sampled(), estimate, support, {}, changes).is_unsupported[extremity], 1);
}

TEST(TakeBackSupported, AFlatPartDisturbsNothingAroundIt)
{
  const CoarseBody& body = human();
  // Around a place on the trunk, far from all extremities, everything is sent to where its partner is not.
  const std::vector<float>& average = body.landmarks.average_distance;
  const auto middle = static_cast<Index>(std::min_element(average.begin(), average.end()) - average.begin());
  Support support;
  support.is_unsupported = around(body, middle, 0.12F);
  support.is_disturbed = support.is_unsupported;
  SampleEstimate estimate = estimateOf(body);
  const Index elsewhere = body.landmarks.extremities.front();
  for (std::size_t i = 0; i < support.is_unsupported.size(); ++i) {
    if (support.is_unsupported[i] != 0) {
      estimate.landmark_map[i] = elsewhere;
      estimate.partners[i] = body.coarse.cells.vertices[elsewhere];
    }
  }
  std::vector<float> changes(body.landmarks.size(), 1.0F);
  const Support rest = takeBackSupported(body.sampled(), estimate, support, {}, changes);
  EXPECT_GT(rest.unsupported_share, 0.0F);
  EXPECT_EQ(rest.is_disturbed, support.is_unsupported);
}

TEST(UnsupportedParts, AreNamedByShareExtentAndExtremePoint)
{
  const CoarseBody& body = human();
  const PreparedSurface& surface = body.surface;
  const Index tip = body.coarse.cells.vertices[body.landmarks.extremities.front()];
  const std::vector<float> from_tip = distanceField(surface.graph, tip);
  std::vector<char> is_unsupported(surface.size(), 0);
  std::size_t count = 0;
  const float radius = 0.1F * body.landmarks.diameter;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    is_unsupported[v] = static_cast<char>(from_tip[v] < radius);
    count += static_cast<std::size_t>(is_unsupported[v]);
  }
  const std::vector<UnsupportedPart> parts = unsupportedParts(surface, is_unsupported);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].points, count);
  EXPECT_GT(parts[0].share, 0.0F);
  EXPECT_LT(parts[0].share, 0.2F);
  EXPECT_LE(parts[0].extent, 1.5F * radius);
  EXPECT_GT(parts[0].extent, 0.5F * radius);
  EXPECT_EQ(is_unsupported[parts[0].extreme], 1);
  EXPECT_TRUE(unsupportedParts(surface, std::vector<char>(surface.size(), 0)).empty());
  EXPECT_TRUE(unsupportedParts(surface, std::vector<char>(surface.size(), 1)).empty()) << "nothing to be far from";
}

} // namespace
