#include "support/coarse_body.h"
#include "symmetry/map_asymmetry.h"
#include "symmetry/map_confidence.h"
#include "symmetry/map_repair.h"
#include "symmetry/map_score.h"

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

/** Hubs within a radius, as a share of the diameter, of one of them. */
std::vector<Index>
hubsAround(const HubSurface& hubs, Index centre, float radius)
{
  std::vector<Index> found;
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    if (hubs.distances(centre, static_cast<Eigen::Index>(i)) < radius * hubs.diameter) {
      found.push_back(static_cast<Index>(i));
    }
  }
  return found;
}

/** The extremity that the true map leaves nearest to where it is: the head of a human. */
Index
stationaryExtremity(const CoarseBody& body, const SampleMap& truth)
{
  Index best = body.hubs.extremities.front();
  for (const Index e : body.hubs.extremities) {
    if (body.hubs.distances(e, truth[e]) < body.hubs.distances(best, truth[best])) {
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
  for (const Index hub : hubsAround(body.hubs, stationaryExtremity(body, map), 0.11F)) {
    map[hub] = hub;
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

TEST(ReversalAtHubs, IsNegativeWhereTheMapKeepsTheOrientation)
{
  const SampleMap truth = human().trueMap();
  const std::vector<Index> head = hubsAround(human().hubs, stationaryExtremity(human(), truth), 0.08F);
  ASSERT_GE(head.size(), 5U);
  EXPECT_GT(averageOf(reversalAtHubs(human().hubs, truth), head), 0.3F);
  EXPECT_LT(averageOf(reversalAtHubs(human().hubs, mapWithUnmirroredHead(human())), head), -0.5F);
}

TEST(RepairedMap, MirrorsAHeadThatWasLeftAsItIs)
{
  const SampleMap truth = human().trueMap();
  const SampleMap broken = mapWithUnmirroredHead(human());
  const SampleMap repaired = repairedMap(human().hubs, broken);
  ASSERT_EQ(repaired.size(), broken.size());
  EXPECT_LT(mapDifference(human().hubs, repaired, truth), 0.5F * mapDifference(human().hubs, broken, truth));
  const std::vector<Index> head = hubsAround(human().hubs, stationaryExtremity(human(), truth), 0.08F);
  EXPECT_GT(averageOf(reversalAtHubs(human().hubs, repaired), head), 0.3F);
}

TEST(RepairedMap, IsNoneWhereMostOfTheMapKeepsTheOrientation)
{
  SampleMap identity(human().hubs.size());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_TRUE(repairedMap(human().hubs, identity).empty());
}

TEST(StretchAtHubs, IsNoneForTheIdentityAndLargeAtATear)
{
  SampleMap map(human().hubs.size());
  std::iota(map.begin(), map.end(), 0);
  for (const float stretch : stretchAtHubs(human().hubs, map)) {
    EXPECT_EQ(stretch, 0.0F);
  }
  Eigen::Index far = 0;
  human().hubs.distances.col(0).maxCoeff(&far);
  map[0] = static_cast<Index>(far);
  EXPECT_GT(stretchAtHubs(human().hubs, map)[0], 2.0F);
}

TEST(RelaxedMap, HealsATear)
{
  const SampleMap truth = human().trueMap();
  SampleMap torn = truth;
  Eigen::Index far = 0;
  human().hubs.distances.col(truth[20]).maxCoeff(&far);
  torn[20] = static_cast<Index>(far);
  const SampleMap healed = relaxedMap(human().hubs, torn);
  EXPECT_LT(human().hubs.distances(healed[20], truth[20]), 0.05F * human().hubs.diameter);
}

TEST(Asymmetry, IsLargerWherePartOfTheMapGoesAstray)
{
  const SampleMap truth = human().trueMap();
  SampleMap astray = truth;
  // One foot or hand on the other side's: as if it were missing there.
  const Index limb = human().hubs.extremities[0] == stationaryExtremity(human(), truth) ? human().hubs.extremities[1]
                                                                                        : human().hubs.extremities[0];
  for (const Index hub : hubsAround(human().hubs, limb, 0.15F)) {
    astray[hub] = truth[hubsAround(human().hubs, limb, 0.2F).back()];
  }
  const float good = asymmetry(findAsymmetry(human().hubs, truth), 0.3F);
  const float bad = asymmetry(findAsymmetry(human().hubs, astray), 0.3F);
  EXPECT_LT(good, bad);
  EXPECT_FALSE(isAsymmetric(good));
  EXPECT_GT(symmetryConfidence(good), symmetryConfidence(bad));
  EXPECT_GT(asymmetry(findAsymmetry(human().hubs, truth), 0.6F), good);
}

} // namespace
