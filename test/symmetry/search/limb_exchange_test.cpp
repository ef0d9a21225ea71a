#include "support/quadruped.h"
#include "support/with_threads.h"
#include "symmetry/search/limb_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** The two extremities of one pair of legs: those whose true partners are farthest away. */
std::pair<Index, Index>
endsOfLegs(const CoarseBody& body, const SampleMap& truth)
{
  const std::vector<Index> ends = extremitiesOf(body.landmarks, limb_separation, most_limbs);
  const Index first = *std::max_element(ends.begin(), ends.end(), [&](Index a, Index b) {
    return body.landmarks.distances(a, truth[a]) < body.landmarks.distances(b, truth[b]);
  });
  return {first, truth[first]};
}

/** The true map but for two legs, which stand still. */
SampleMap
mapWithStandingLegs(const CoarseBody& body, const SampleMap& truth)
{
  SampleMap map = truth;
  const auto [first, second] = endsOfLegs(body, truth);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (std::min(body.landmarks.distances(row, first), body.landmarks.distances(row, second)) <
        0.2F * body.landmarks.diameter) {
      map[i] = static_cast<Index>(i);
    }
  }
  return map;
}

float
leastDifference(const CoarseBody& body, const std::vector<SymmetryCandidate>& candidates, const SampleMap& truth)
{
  float least = 1.0F;
  for (const SymmetryCandidate& candidate : candidates) {
    least = std::min(least, mapDifference(body.landmarks, candidate.map, truth));
  }
  return least;
}

TEST(LimbExchange, MakesLegsThatStandStillChangePlaces)
{
  const SampleMap truth = quadruped().trueMap();
  const SampleMap wrong = mapWithStandingLegs(quadruped(), truth);
  ASSERT_GT(mapDifference(quadruped().landmarks, wrong, truth), 0.04F);
  const std::vector<SymmetryCandidate> candidates = exchangeLimbs(quadruped().sampled(), {wrong}, {}, {});
  ASSERT_FALSE(candidates.empty());
  EXPECT_LE(candidates.size(), LimbExchangeSettings{}.exchanges);
  EXPECT_LT(leastDifference(quadruped(), candidates, truth), 0.025F) << "about the spacing of the landmarks";
}

TEST(LimbExchange, AlsoUndoesAnExchange)
{
  const SampleMap truth = quadruped().trueMap();
  const std::vector<SymmetryCandidate> candidates = exchangeLimbs(quadruped().sampled(), {truth}, {}, {});
  const auto [first, second] = endsOfLegs(quadruped(), truth);
  EXPECT_TRUE(std::any_of(candidates.begin(), candidates.end(),
                          [&, end = first](const SymmetryCandidate& candidate) {
                            return quadruped().landmarks.distances(end, candidate.map[end]) <
                                   0.5F * limb_separation * quadruped().landmarks.diameter;
                          }))
      << "the legs of one pair, from " << second << " on, stand still in none";
}

TEST(LimbExchange, LeavesAloneWhatSendsEndsNowhere)
{
  const LandmarkSurface& landmarks = quadruped().landmarks;
  // All to the landmark in the middle, which no end is near to.
  const auto middle =
      static_cast<Index>(std::min_element(landmarks.average_distance.begin(), landmarks.average_distance.end()) -
                         landmarks.average_distance.begin());
  EXPECT_TRUE(exchangeLimbs(quadruped().sampled(), {SampleMap(landmarks.size(), middle)}, {}, {}).empty());
}

/** The best of several maps may be another kind of mistake, from which no exchange leads to the right one. */
TEST(LimbExchange, StartsFromEachMap)
{
  const SampleMap truth = quadruped().trueMap();
  SampleMap nobody_moves(truth.size());
  std::iota(nobody_moves.begin(), nobody_moves.end(), 0);
  const auto exchanged = [](const std::vector<SampleMap>& maps) {
    return exchangeLimbs(quadruped().sampled(), maps, {}, {});
  };
  EXPECT_GT(leastDifference(quadruped(), exchanged({nobody_moves}), truth), 0.04F);
  const SampleMap wrong = mapWithStandingLegs(quadruped(), truth);
  EXPECT_LT(leastDifference(quadruped(), exchanged({nobody_moves, wrong}), truth), 0.025F);
}

TEST(LimbExchange, MakesNoMapTwice)
{
  const SampleMap truth = quadruped().trueMap();
  const SampleMap wrong = mapWithStandingLegs(quadruped(), truth);
  const std::size_t of_truth = exchangeLimbs(quadruped().sampled(), {truth}, {}, {}).size();
  EXPECT_EQ(exchangeLimbs(quadruped().sampled(), {truth, truth}, {}, {}).size(), of_truth);

  // Each is an exchange of the other: none of the candidates pairs the ends as one of them does.
  const std::vector<SymmetryCandidate> of_both = exchangeLimbs(quadruped().sampled(), {truth, wrong}, {}, {});
  ASSERT_FALSE(of_both.empty());
  EXPECT_GT(leastDifference(quadruped(), of_both, truth), 0.03F);
  EXPECT_GT(leastDifference(quadruped(), of_both, wrong), 0.03F);
}

TEST(LimbExchange, DoesNotDependOnTheNumberOfThreads)
{
  const SampleMap truth = quadruped().trueMap();
  const auto run = [&] {
    return exchangeLimbs(quadruped().sampled(), {truth}, {}, {});
  };
  const std::vector<SymmetryCandidate> one = withThreads(1, run);
  const std::vector<SymmetryCandidate> three = withThreads(3, run);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].map, three[i].map);
    EXPECT_EQ(one[i].score.value, three[i].score.value);
  }
}

} // namespace
