#include "support/quadruped.h"
#include "support/with_threads.h"
#include "symmetry/search/given_maps.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(LandmarkMaps, AreThoseOfThePoints)
{
  const CoarseBody& body = quadruped();
  const std::vector<SampleMap> maps = landmarkMapsOf(body.sampled(), {body.model.partners});
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps[0], body.trueMap());
}

TEST(LandmarkMaps, TakeWhatIsUnknownFromTheNearestThatIsKnown)
{
  const CoarseBody& body = quadruped();
  std::vector<Index> partners = body.model.partners;
  for (std::size_t i = 1; i < body.landmarks.size(); ++i) {
    partners[body.coarse.cells.vertices[i]] = i % 3 == 0 ? no_index : partners[body.coarse.cells.vertices[i]];
  }
  const std::vector<SampleMap> maps = landmarkMapsOf(body.sampled(), {partners});
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_LT(mapDifference(body.landmarks, maps[0], body.trueMap()), 0.05F);
}

TEST(LandmarkMaps, LeaveOutWhatIsKnownOfNone)
{
  const CoarseBody& body = quadruped();
  const std::vector<Index> nothing(body.surface.size(), no_index);
  EXPECT_EQ(landmarkMapsOf(body.sampled(), {nothing, body.model.partners}).size(), 1U);
  EXPECT_TRUE(landmarkMapsOf(body.sampled(), {}).empty());
}

TEST(CandidatesFromMaps, StayWhatTheyAreAndHaveScores)
{
  const CoarseBody& body = quadruped();
  const SampleMap truth = body.trueMap();
  const auto run = [&] {
    return candidatesFromMaps(body.sampled(), {truth, SampleMap(truth.size(), 0)}, {});
  };
  const std::vector<SymmetryCandidate> candidates = run();
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_LT(mapDifference(body.landmarks, candidates[0].map, truth), 0.025F) << "about the spacing of the landmarks";
  EXPECT_LT(candidates[0].score.value, candidates[1].score.value);
  EXPECT_EQ(candidates[0].map, withThreads(3, run)[0].map);
  EXPECT_TRUE(candidatesFromMaps(body.sampled(), {}, {}).empty());
}

} // namespace
