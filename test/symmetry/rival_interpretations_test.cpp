#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/point_confidence.h"
#include "symmetry/rival_interpretations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace pcl::symmetry;

namespace {

constexpr Index number = 200;

/** Points along a line; point i has the partner first + i, modulo their number. */
Interpretation
interpretationOf(Index first, float confidence, SymmetryStatus status = SymmetryStatus::Symmetric)
{
  Interpretation interpretation;
  for (Index i = 0; i < number; ++i) {
    interpretation.surface.points.push_back({static_cast<float>(i) / static_cast<float>(number), 0.0F, 0.0F});
    interpretation.surface.representatives.push_back(i);
    interpretation.surface.original.push_back(i);
    if (status == SymmetryStatus::Symmetric) {
      interpretation.estimate.partners.push_back((first + i) % number);
    }
  }
  interpretation.estimate.confidence = confidence;
  interpretation.estimate.trust = confidence;
  interpretation.estimate.status = status;
  return interpretation;
}

/** As above, where the second half of the points has no counterpart. */
Interpretation
interpretationOfHalf(Index first, float trust)
{
  Interpretation interpretation = interpretationOf(first, trust);
  interpretation.estimate.status = SymmetryStatus::NoSymmetry;
  interpretation.estimate.is_partial = true;
  interpretation.estimate.is_unsupported.assign(number, 0);
  for (Index i = number / 2; i < number; ++i) {
    interpretation.estimate.is_unsupported[i] = 1;
    interpretation.estimate.partners[i] = i - number / 4; // does not count
  }
  return interpretation;
}

Interpretation
withMisfit(Interpretation interpretation, float misfit)
{
  interpretation.estimate.misfit = misfit;
  return interpretation;
}

TEST(RivalInterpretations, TheHigherConfidenceIsTheBetter)
{
  RivalInterpretations rivals;
  EXPECT_FALSE(rivals.isSettled());
  rivals.add(interpretationOf(0, 0.4F));
  rivals.add(interpretationOf(100, 0.6F));
  EXPECT_FALSE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.6F);
}

TEST(RivalInterpretations, SeveralThatAgreeOutweighOneThatIsSure)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.7F));
  rivals.add(interpretationOf(3, 0.8F)); // nearly the same map
  rivals.add(interpretationOf(100, 0.97F));
  EXPECT_FALSE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.8F);
  rivals.add(interpretationOf(100, 0.9F));
  EXPECT_TRUE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.97F);
}

TEST(RivalInterpretations, OneBeyondDoubtSettlesWhatIsNotContradicted)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.5F));
  rivals.add(interpretationOf(1, 0.95F));
  EXPECT_TRUE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.95F);
}

TEST(RivalInterpretations, WhatOthersContradictTogetherIsNotSettled)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(60, 0.6F));
  rivals.add(interpretationOf(120, 0.5F));
  rivals.add(interpretationOf(0, 0.95F));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.95F);
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalInterpretations, ThreeThatAgreeSettleWhatNoneSettlesAlone)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.7F));
  rivals.add(interpretationOf(1, 0.7F));
  EXPECT_FALSE(rivals.isSettled());
  rivals.add(interpretationOf(2, 0.7F));
  EXPECT_TRUE(rivals.isSettled());
}

TEST(RivalInterpretations, ThreeOutOfManySettleNothing)
{
  RivalInterpretations rivals;
  for (Index i = 0; i < 3; ++i) {
    rivals.add(interpretationOf(i, 0.01F, SymmetryStatus::NoSymmetry));
  }
  for (Index i = 0; i < 3; ++i) {
    rivals.add(interpretationOf(i, 0.7F));
  }
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalInterpretations, SymmetryIsBetterThanNone)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  rivals.add(interpretationOf(0, 0.09F, SymmetryStatus::NoSymmetry));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.09F);
  rivals.add(interpretationOf(0, 0.2F));
  rivals.add(interpretationOf(0, 0.08F, SymmetryStatus::NoSymmetry));
  EXPECT_EQ(rivals.best().estimate.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(rivals.best().estimate.confidence, 0.2F);
}

TEST(RivalInterpretations, WhatGoesNowhereContradictsNothing)
{
  Interpretation partial = interpretationOf(0, 0.5F);
  for (Index i = 50; i < number; ++i) {
    partial.surface.representatives[i] = no_index;
  }
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.3F));
  rivals.add(std::move(partial));
  rivals.add(interpretationOf(100, 0.7F));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.5F); // 0.3 + 0.5 against 0.7
}

TEST(RivalInterpretations, ConfidenceIsThatOfAllInterpretations)
{
  RivalInterpretations one;
  one.add(interpretationOf(0, 0.4F));
  EXPECT_EQ(one.takeBest().estimate.confidence, 0.4F);

  RivalInterpretations several;
  Interpretation with_alternatives = interpretationOf(0, 0.8F);
  with_alternatives.estimate.alternatives.push_back({{}, 0.0F, 0.8F, true});
  several.add(std::move(with_alternatives));
  several.add(interpretationOf(0, 0.4F));
  several.add(interpretationOf(100, 0.7F));
  several.add(interpretationOf(0, 0.0F, SymmetryStatus::NoSymmetry));
  Interpretation best = several.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::Symmetric);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.8F * 0.3F), 1e-5F);
  EXPECT_NEAR(best.estimate.alternatives.at(0).confidence, best.estimate.confidence, 1e-5F);
  EXPECT_TRUE(best.estimate.message.empty());
}

TEST(RivalInterpretations, OneTryOutOfManyIsNoSymmetry)
{
  RivalInterpretations rivals;
  for (int i = 0; i < 14; ++i) {
    rivals.add(interpretationOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  }
  rivals.add(interpretationOf(0, 0.3F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::NoSymmetry);
  EXPECT_NEAR(best.estimate.confidence, confidence_of_refused * std::sqrt(0.3F * 0.02F), 1e-5F);
  EXPECT_FALSE(best.estimate.message.empty());
}

/** What comes out of an interpretation that found a map and three that found none: half of its confidence is left. */
SymmetryStatus
statusAfterThreeThatFindNothing(Interpretation found)
{
  RivalInterpretations rivals;
  for (int i = 0; i < 3; ++i) {
    rivals.add(interpretationOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  }
  rivals.add(std::move(found));
  return rivals.takeBest().estimate.status;
}

TEST(RivalInterpretations, NoiseExcusesInterpretationsThatFindNothing)
{
  Interpretation found = interpretationOf(0, 0.36F);
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
  found.surface.summary.smoothing_radius = 0.1F;
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::Symmetric);
}

TEST(RivalInterpretations, PointsAtRandomPlacesExcuseInterpretationsThatFindNothing)
{
  Interpretation found = interpretationOf(0, 0.36F);
  found.surface.graph.offsets = {0, 2};
  found.surface.graph.neighbours = {0, 0};
  found.surface.graph.lengths = {0.3F, 0.3F};
  found.surface.is_cloud = true;
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
  found.surface.graph.lengths = {0.1F, 0.3F}; // on average twice the nearest
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::Symmetric);
  found.surface.is_cloud = false; // faces tell what is between the points
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
}

TEST(RivalInterpretations, PointsAreTrustedAsTheMapIs)
{
  RivalInterpretations rivals;
  Interpretation interpretation = interpretationOf(0, 0.8F);
  interpretation.estimate.confidences.assign(number, 0.4F);
  rivals.add(interpretationOf(0, 0.0F, SymmetryStatus::NoSymmetry));
  rivals.add(std::move(interpretation));
  const Interpretation best = rivals.takeBest();
  EXPECT_LT(best.estimate.confidence, 0.8F);
  EXPECT_FLOAT_EQ(best.estimate.confidences[7], withMapConfidence(0.4F, 0.8F, best.estimate.confidence));
}

TEST(RivalInterpretations, TooFewPointsSettleAtOnce)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.0F, SymmetryStatus::TooFewPoints));
  EXPECT_TRUE(rivals.isSettled());
}

/** As interpretationOf (), with a map whether it is refused or not. */
Interpretation
mapOf(Index first, float trust, bool is_partial = false)
{
  Interpretation interpretation = interpretationOf(first, trust);
  interpretation.estimate.map_confidence = trust;
  interpretation.estimate.trust = trust;
  interpretation.estimate.is_partial = is_partial;
  interpretation.estimate.confidences.assign(number, trust);
  return interpretation;
}

TEST(RivalsByOdds, OneThatIsSureIsEnough)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(0, 0.9F));
  EXPECT_TRUE(rivals.isSettled());
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::Symmetric);
  EXPECT_NEAR(best.estimate.confidence, 0.9F, 1e-4F);
}

TEST(RivalsByOdds, TheBestSpeaksForItsMapHoweverDoubtfulOthersAre)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(100, 0.1F));
  rivals.add(mapOf(0, 0.6F));
  rivals.add(mapOf(0, 0.1F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.partners[0], 0);
  EXPECT_NEAR(best.estimate.confidence, 1.5F / (1.0F + 1.5F + 1.0F / 9.0F), 1e-4F);
}

TEST(RivalsByOdds, MapsExcludeEachOther)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(0, 0.7F));
  rivals.add(mapOf(100, 0.7F));
  rivals.add(mapOf(0, 0.7F));
  EXPECT_FALSE(rivals.isSettled());
  const Interpretation best = rivals.takeBest();
  EXPECT_LT(best.estimate.confidence, 0.5F);
  EXPECT_FLOAT_EQ(best.estimate.confidences[0], withMapConfidence(0.7F, 0.7F, best.estimate.confidence));
}

TEST(RivalsByOdds, AMapInDoubtThatMostDoNotFindIsNone)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(0, 0.6F));
  rivals.add(mapOf(50, 0.1F));
  rivals.add(mapOf(0, 0.5F));
  rivals.add(mapOf(100, 0.1F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::NoSymmetry);
  EXPECT_EQ(best.estimate.message, "ways to understand the surface contradict each other");
  EXPECT_LT(best.estimate.confidence, 0.1F);
}

TEST(RivalsByOdds, AMapThatIsSureNeedsNoOtherToFindIt)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(50, 0.1F));
  rivals.add(mapOf(100, 0.2F));
  rivals.add(mapOf(0, 0.9F));
  EXPECT_TRUE(rivals.isSettled());
  EXPECT_EQ(rivals.takeBest().estimate.status, SymmetryStatus::Symmetric);
}

TEST(RivalsByOdds, ThreeThatFindOneMapSettleItIfItIsMoreLikelyThanNot)
{
  RivalInterpretations likely(Pooling::Odds);
  likely.add(mapOf(0, 0.6F));
  likely.add(mapOf(1, 0.1F));
  EXPECT_FALSE(likely.isSettled());
  likely.add(mapOf(2, 0.1F));
  EXPECT_TRUE(likely.isSettled());

  RivalInterpretations unlikely(Pooling::Odds);
  for (int i = 0; i < 3; ++i) {
    unlikely.add(mapOf(0, 0.4F));
  }
  EXPECT_FALSE(unlikely.isSettled());
}

TEST(RivalsByOdds, ThreeThatFindOneMapSettleNothingWhereAFourthFindsAnother)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(100, 0.1F));
  for (int i = 0; i < 3; ++i) {
    rivals.add(mapOf(0, 0.6F));
  }
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalsByOdds, ThreeThatFindOnePartialMapSettleNothing)
{
  RivalInterpretations rivals(Pooling::Odds);
  for (int i = 0; i < 3; ++i) {
    rivals.add(mapOf(0, 0.9F, true));
  }
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalsByOdds, WhatIsDoubtfulThroughoutIsNoSymmetry)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(0, 0.15F));
  rivals.add(mapOf(0, 0.2F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::NoSymmetry);
  EXPECT_LT(best.estimate.confidence, 0.1F);
}

/** A refused map of which a closer look shows that it can be trusted on a part: but for twenty points from \a from on. */
Interpretation
trustedInPart(Index first, float trust, std::ptrdiff_t from = 0)
{
  Interpretation interpretation = mapOf(first, 0.05F);
  interpretation.estimate.status = SymmetryStatus::NoSymmetry;
  interpretation.estimate.is_unsupported.assign(number, 0);
  std::fill_n(interpretation.estimate.is_unsupported.begin() + from, 20, char{1});
  interpretation.estimate.trust_of_part = trust;
  return interpretation;
}

TEST(RivalsByOdds, OfWhatIsRefusedTheMapOfAPartIsTakenThatIsTrustedMost)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(trustedInPart(0, 0.6F));
  rivals.add(trustedInPart(100, 0.8F));
  rivals.add(trustedInPart(50, 0.7F));
  EXPECT_FALSE(rivals.isSettled());
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::PartlySymmetric);
  EXPECT_EQ(best.estimate.confidence, 0.8F);
  EXPECT_EQ(best.estimate.partners[0], 100U);
}

TEST(RivalsByOdds, APartThatOneCloserLookAloneLeavesOutIsChance)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(trustedInPart(0, 0.9F));
  rivals.add(trustedInPart(0, 0.8F, 60));
  rivals.add(trustedInPart(0, 0.7F, 10)); // shares ten of thirty points with the first
  EXPECT_EQ(rivals.takeBest().estimate.status, SymmetryStatus::NoSymmetry);
}

TEST(RivalsByOdds, WhatTwoCloserLooksLeaveOutIsTakenBeforeWhatIsTrustedMore)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(trustedInPart(0, 0.9F, 100));
  rivals.add(trustedInPart(50, 0.6F, 0));
  rivals.add(trustedInPart(70, 0.7F, 6)); // shares fourteen of twenty-six points
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::PartlySymmetric);
  EXPECT_EQ(best.estimate.partners[0], 70U);
  EXPECT_EQ(best.estimate.confidence, 0.7F);
}

TEST(RivalsByOdds, AnEarlierCloserLookIsTakenWhereALaterOneConfirmsIt)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(trustedInPart(50, 0.9F, 0));
  rivals.add(trustedInPart(60, 0.6F, 100));
  rivals.add(trustedInPart(70, 0.7F, 6));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.partners[0], 50U);
  EXPECT_EQ(best.estimate.confidence, 0.9F);
}

TEST(RivalsByOdds, AMapOfTheWholeIsBetterThanOneThatOnlyACloserLookShows)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(trustedInPart(100, 0.9F));
  rivals.add(mapOf(0, 0.5F));
  rivals.add(mapOf(0, 0.3F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(best.estimate.partners[0], 0U);
}

TEST(RivalsByOdds, APartialMapIsTakenButSettlesNothing)
{
  RivalInterpretations rivals(Pooling::Odds);
  rivals.add(mapOf(0, 0.9F, true));
  EXPECT_FALSE(rivals.isSettled());
  rivals.add(mapOf(100, 0.3F));
  EXPECT_EQ(rivals.takeBest().estimate.status, SymmetryStatus::PartlySymmetric);
}

TEST(RivalsByVotes, TheMapThatFitsBestIsKept)
{
  RivalInterpretations rivals;
  rivals.add(withMisfit(interpretationOf(0, 0.5F), -4.0F));
  rivals.add(withMisfit(interpretationOf(2, 0.3F), -6.0F));
  rivals.add(withMisfit(interpretationOf(4, 0.7F), -5.0F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.partners[0], 2);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.5F * 0.7F), 1e-5F) << "as far as any of them can be trusted";
}

TEST(RivalsByVotes, ARefusedMapHasNoVoteButMayFitBest)
{
  const auto refused = [](Index first, float misfit) {
    Interpretation interpretation = withMisfit(interpretationOf(first, 0.3F), misfit);
    interpretation.estimate.status = SymmetryStatus::NoSymmetry;
    return interpretation;
  };
  RivalInterpretations rivals;
  rivals.add(refused(100, -5.0F));
  rivals.add(refused(100, -5.0F));
  rivals.add(withMisfit(interpretationOf(0, 0.55F), -4.0F));
  EXPECT_EQ(rivals.best().estimate.partners[0], 0); // 0.55 against none
  rivals.add(refused(2, -6.0F));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.partners[0], 2) << "the same map, and it fits better";
  EXPECT_EQ(best.estimate.status, SymmetryStatus::Symmetric);
}

TEST(RivalsByVotes, AMapOfAPartSpeaksForTheSameMapOfTheWhole)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.5F));
  rivals.add(interpretationOf(100, 0.7F));
  rivals.add(interpretationOfHalf(0, 0.4F));
  EXPECT_EQ(rivals.best().estimate.partners[0], 0); // 0.5 + 0.4 against 0.7
}

TEST(RivalsByVotes, ThoseThatFitTellWhetherTheWholeIsSymmetric)
{
  RivalInterpretations whole;
  whole.add(withMisfit(interpretationOf(0, 0.5F), -6.0F));
  whole.add(withMisfit(interpretationOfHalf(0, 0.8F), -5.0F)); // distances change 2.7 times as much
  EXPECT_EQ(whole.takeBest().estimate.status, SymmetryStatus::Symmetric);

  RivalInterpretations part;
  part.add(withMisfit(interpretationOf(0, 0.5F), -5.0F));
  part.add(withMisfit(interpretationOfHalf(0, 0.8F), -5.0F));
  const Interpretation best = part.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::PartlySymmetric);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.65F * 0.8F), 1e-5F);
}

TEST(RivalsByVotes, AMapOfAPartSettlesNothing)
{
  RivalInterpretations rivals;
  for (int i = 0; i < 4; ++i) {
    rivals.add(interpretationOfHalf(0, 0.95F));
  }
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalsByVotes, AMapOfAPartIsFoundWhereNoneOfTheWholeIs)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOfHalf(0, 0.8F));
  rivals.add(interpretationOf(0, 0.03F, SymmetryStatus::NoSymmetry));
  const Interpretation best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::PartlySymmetric);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.4F * 0.8F), 1e-4F);
}

TEST(RivalInterpretations, HandOnTheirMapsToTheNextInterpretation)
{
  RivalInterpretations rivals;
  rivals.add(interpretationOf(0, 0.01F, SymmetryStatus::NoSymmetry)); // no map
  rivals.add(interpretationOf(10, 0.3F));
  rivals.add(interpretationOf(100, 0.6F));
  PreparedSurface next; // of every second point of the input
  next.representatives.assign(number, no_index);
  for (Index i = 0; i < number; i += 2) {
    next.representatives[i] = i / 2;
    next.points.emplace_back();
    next.original.push_back(i);
  }
  const std::vector<std::vector<Index>> maps = rivals.mapsOn(next);
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0][0], 50) << "the most trusted one first";
  EXPECT_EQ(maps[1][0], 5);
  EXPECT_EQ(maps[1][97], 2) << "the points go around";
}

} // namespace
