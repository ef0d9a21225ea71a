#include "symmetry/readings.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

constexpr Index number = 200;

/** Points along a line; point i has the partner first + i, modulo their number. */
Reading
readingOf(Index first, float confidence, SymmetryStatus status = SymmetryStatus::Symmetric)
{
  Reading reading;
  for (Index i = 0; i < number; ++i) {
    reading.surface.points.push_back({static_cast<float>(i) / static_cast<float>(number), 0.0F, 0.0F});
    reading.surface.representatives.push_back(i);
    if (status == SymmetryStatus::Symmetric) {
      reading.estimate.partners.push_back((first + i) % number);
    }
  }
  reading.estimate.confidence = confidence;
  reading.estimate.status = status;
  return reading;
}

TEST(RivalReadings, TheHigherConfidenceIsTheBetter)
{
  RivalReadings rivals;
  EXPECT_FALSE(rivals.isSettled());
  rivals.add(readingOf(0, 0.4F));
  rivals.add(readingOf(100, 0.6F));
  EXPECT_FALSE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.6F);
}

TEST(RivalReadings, SeveralThatAgreeOutweighOneThatIsSure)
{
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.7F));
  rivals.add(readingOf(3, 0.8F)); // nearly the same map
  rivals.add(readingOf(100, 0.97F));
  EXPECT_FALSE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.8F);
  rivals.add(readingOf(100, 0.9F));
  EXPECT_TRUE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.97F);
}

TEST(RivalReadings, OneBeyondDoubtSettlesWhatIsNotContradicted)
{
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.5F));
  rivals.add(readingOf(1, 0.95F));
  EXPECT_TRUE(rivals.isSettled());
  EXPECT_EQ(rivals.best().estimate.confidence, 0.95F);
}

TEST(RivalReadings, WhatOthersContradictTogetherIsNotSettled)
{
  RivalReadings rivals;
  rivals.add(readingOf(60, 0.6F));
  rivals.add(readingOf(120, 0.5F));
  rivals.add(readingOf(0, 0.95F));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.95F);
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalReadings, ThreeThatAgreeSettleWhatNoneSettlesAlone)
{
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.7F));
  rivals.add(readingOf(1, 0.7F));
  EXPECT_FALSE(rivals.isSettled());
  rivals.add(readingOf(2, 0.7F));
  EXPECT_TRUE(rivals.isSettled());
}

TEST(RivalReadings, ThreeOutOfManySettleNothing)
{
  RivalReadings rivals;
  for (Index i = 0; i < 3; ++i) {
    rivals.add(readingOf(i, 0.01F, SymmetryStatus::NoSymmetry));
  }
  for (Index i = 0; i < 3; ++i) {
    rivals.add(readingOf(i, 0.7F));
  }
  EXPECT_FALSE(rivals.isSettled());
}

TEST(RivalReadings, SymmetryIsBetterThanNone)
{
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  rivals.add(readingOf(0, 0.09F, SymmetryStatus::NoSymmetry));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.09F);
  rivals.add(readingOf(0, 0.2F));
  rivals.add(readingOf(0, 0.08F, SymmetryStatus::NoSymmetry));
  EXPECT_EQ(rivals.best().estimate.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(rivals.best().estimate.confidence, 0.2F);
}

TEST(RivalReadings, WhatGoesNowhereContradictsNothing)
{
  Reading partial = readingOf(0, 0.5F);
  for (Index i = 50; i < number; ++i) {
    partial.surface.representatives[i] = no_index;
  }
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.3F));
  rivals.add(std::move(partial));
  rivals.add(readingOf(100, 0.7F));
  EXPECT_EQ(rivals.best().estimate.confidence, 0.5F); // 0.3 + 0.5 against 0.7
}

TEST(RivalReadings, ConfidenceIsThatOfAllReadings)
{
  RivalReadings one;
  one.add(readingOf(0, 0.4F));
  EXPECT_EQ(one.takeBest().estimate.confidence, 0.4F);

  RivalReadings several;
  Reading with_alternatives = readingOf(0, 0.8F);
  with_alternatives.estimate.alternatives.push_back({{}, 0.0F, 0.8F, true});
  several.add(std::move(with_alternatives));
  several.add(readingOf(0, 0.4F));
  several.add(readingOf(100, 0.7F));
  several.add(readingOf(0, 0.0F, SymmetryStatus::NoSymmetry));
  Reading best = several.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::Symmetric);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.8F * 0.3F), 1e-5F);
  EXPECT_NEAR(best.estimate.alternatives.at(0).confidence, best.estimate.confidence, 1e-5F);
  EXPECT_TRUE(best.estimate.message.empty());
}

TEST(RivalReadings, OneTryOutOfManyIsNoSymmetry)
{
  RivalReadings rivals;
  for (int i = 0; i < 14; ++i) {
    rivals.add(readingOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  }
  rivals.add(readingOf(0, 0.3F));
  const Reading best = rivals.takeBest();
  EXPECT_EQ(best.estimate.status, SymmetryStatus::NoSymmetry);
  EXPECT_NEAR(best.estimate.confidence, std::sqrt(0.3F * 0.02F), 1e-5F);
  EXPECT_FALSE(best.estimate.message.empty());
}

/** What comes out of a reading that found a map and three that found none: half of its confidence is left. */
SymmetryStatus
statusAfterThreeThatFindNothing(Reading found)
{
  RivalReadings rivals;
  for (int i = 0; i < 3; ++i) {
    rivals.add(readingOf(0, 0.01F, SymmetryStatus::NoSymmetry));
  }
  rivals.add(std::move(found));
  return rivals.takeBest().estimate.status;
}

TEST(RivalReadings, NoiseExcusesReadingsThatFindNothing)
{
  Reading found = readingOf(0, 0.36F);
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
  found.surface.summary.smoothing_radius = 0.1F;
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::Symmetric);
}

TEST(RivalReadings, PointsAtRandomPlacesExcuseReadingsThatFindNothing)
{
  Reading found = readingOf(0, 0.36F);
  found.surface.graph.offsets = {0, 2};
  found.surface.graph.neighbours = {0, 0};
  found.surface.graph.lengths = {0.3F, 0.3F};
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
  found.surface.graph.lengths = {0.1F, 0.3F}; // on average twice the nearest
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::Symmetric);
}

TEST(RivalReadings, HolesInAMeshExcuseReadingsThatFindNothing)
{
  Reading found = readingOf(0, 0.44F);
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::NoSymmetry);
  found.estimate.known_holes = 0.1F;
  EXPECT_EQ(statusAfterThreeThatFindNothing(found), SymmetryStatus::Symmetric);
}

TEST(RivalReadings, PointsAreTrustedAsTheMapIs)
{
  RivalReadings rivals;
  Reading reading = readingOf(0, 0.8F);
  reading.estimate.confidences.assign(number, 0.4F);
  rivals.add(readingOf(0, 0.0F, SymmetryStatus::NoSymmetry));
  rivals.add(std::move(reading));
  const Reading best = rivals.takeBest();
  EXPECT_NEAR(best.estimate.confidences[7], 0.5F * best.estimate.confidence, 1e-5F);
}

TEST(RivalReadings, TooFewPointsSettleAtOnce)
{
  RivalReadings rivals;
  rivals.add(readingOf(0, 0.0F, SymmetryStatus::TooFewPoints));
  EXPECT_TRUE(rivals.isSettled());
}

TEST(PastReadings, AreThoseOfTheSamePointsWithTheSameContacts)
{
  const ContactTest trusting{0.5F, 3.0F, 0.0F};
  PreparedSurface surface;
  surface.points = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}};
  PastReadings past;
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

} // namespace
