#include "support/coarse_body.h"
#include "symmetry/search/map_regrowth.h"
#include "symmetry/search/map_score.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const CoarseBody&
human()
{
  static const CoarseBody body = coarseBody(Body::Human, 0.0);
  return body;
}

/** Landmarks within a radius, as a share of the diameter, of one of them. */
std::vector<Index>
hubsAround(const LandmarkSurface& landmarks, Index centre, float radius)
{
  std::vector<Index> found;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (landmarks.distances(centre, static_cast<Eigen::Index>(i)) < radius * landmarks.diameter) {
      found.push_back(static_cast<Index>(i));
    }
  }
  return found;
}

/** The extremity that the true map leaves nearest to where it is: the head of a human. */
Index
stationaryExtremity(const CoarseBody& body, const SampleMap& truth)
{
  Index best = body.landmarks.extremities.front();
  for (const Index e : body.landmarks.extremities) {
    if (body.landmarks.distances(e, truth[e]) < body.landmarks.distances(best, truth[best])) {
      best = e;
    }
  }
  return best;
}

/** The true map but for the head, which stays as it is. */
SampleMap
mapWithUnmirroredHead(const CoarseBody& body)
{
  SampleMap map = body.trueMap();
  for (const Index landmark : hubsAround(body.landmarks, stationaryExtremity(body, map), 0.11F)) {
    map[landmark] = landmark;
  }
  return map;
}

float
averageOf(const std::vector<float>& values, const std::vector<Index>& chosen)
{
  float sum = 0.0F;
  for (const Index i : chosen) {
    sum += values[i];
  }
  return sum / static_cast<float>(chosen.size());
}

TEST(ReversalAtLandmarks, IsNegativeWhereTheMapKeepsTheOrientation)
{
  const SampleMap truth = human().trueMap();
  const std::vector<Index> head = hubsAround(human().landmarks, stationaryExtremity(human(), truth), 0.08F);
  ASSERT_GE(head.size(), 5U);
  EXPECT_GT(averageOf(reversalAtLandmarks(human().landmarks, truth), head), 0.3F);
  EXPECT_LT(averageOf(reversalAtLandmarks(human().landmarks, mapWithUnmirroredHead(human())), head), -0.5F);
}

TEST(RegrownMap, MirrorsAHeadThatWasLeftAsItIs)
{
  const SampleMap truth = human().trueMap();
  const SampleMap broken = mapWithUnmirroredHead(human());
  const SampleMap repaired = regrownMap(human().landmarks, broken);
  ASSERT_EQ(repaired.size(), broken.size());
  EXPECT_LT(mapDifference(human().landmarks, repaired, truth), 0.5F * mapDifference(human().landmarks, broken, truth));
  const std::vector<Index> head = hubsAround(human().landmarks, stationaryExtremity(human(), truth), 0.08F);
  EXPECT_GT(averageOf(reversalAtLandmarks(human().landmarks, repaired), head), 0.3F);
}

TEST(RegrownMap, IsNoneWhereMostOfTheMapKeepsTheOrientation)
{
  SampleMap identity(human().landmarks.size());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_TRUE(regrownMap(human().landmarks, identity).empty());
}

TEST(StretchAtLandmarks, IsNoneForTheIdentityAndLargeAtATear)
{
  SampleMap map(human().landmarks.size());
  std::iota(map.begin(), map.end(), 0);
  for (const float stretch : stretchAtLandmarks(human().landmarks, map)) {
    EXPECT_EQ(stretch, 0.0F);
  }
  Eigen::Index far = 0;
  human().landmarks.distances.col(0).maxCoeff(&far);
  map[0] = static_cast<Index>(far);
  EXPECT_GT(stretchAtLandmarks(human().landmarks, map)[0], 2.0F);
}

TEST(RelaxedMap, HealsATear)
{
  const SampleMap truth = human().trueMap();
  SampleMap torn = truth;
  Eigen::Index far = 0;
  human().landmarks.distances.col(truth[20]).maxCoeff(&far);
  torn[20] = static_cast<Index>(far);
  const SampleMap healed = relaxedMap(human().landmarks, torn);
  EXPECT_LT(human().landmarks.distances(healed[20], truth[20]), 0.05F * human().landmarks.diameter);
}

TEST(NearestLandmarks, AreTheNearestInOrderWithoutTheLandmarkItself)
{
  const std::vector<std::vector<Index>> nearest = nearestLandmarks(human().landmarks.distances, 5);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const auto from = human().landmarks.distances.col(static_cast<Eigen::Index>(i));
    ASSERT_EQ(nearest[i].size(), 5U);
    for (std::size_t k = 0; k < nearest[i].size(); ++k) {
      EXPECT_NE(nearest[i][k], static_cast<Index>(i));
      EXPECT_LE(k == 0 ? 0.0F : from(nearest[i][k - 1]), from(nearest[i][k]));
    }
    EXPECT_LE((from.array() < from(nearest[i].back())).count(), 5);
  }
}

TEST(RefittedMap, BringsImagesThatAreALandmarkOrTwoOffCloserToTheTruth)
{
  const LandmarkSurface& landmarks = human().landmarks;
  const SampleMap truth = human().trueMap();
  const std::vector<std::vector<Index>> nearest = nearestLandmarks(landmarks.distances, 6);
  SampleMap blurred = truth;
  for (std::size_t i = 0; i < blurred.size(); ++i) {
    blurred[i] = nearest[truth[i]][i % 6];
  }
  const SampleMap settled = refittedMap(landmarks, blurred, 3);
  EXPECT_LT(mapDifference(landmarks, settled, truth), 0.6F * mapDifference(landmarks, blurred, truth));
}

} // namespace
