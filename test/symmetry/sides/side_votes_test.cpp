#include "support/human.h"
#include "symmetry/sides/side_votes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(SideVotes, SourcesOfTheTrueMapLieOnOneSide)
{
  const OrderedPairs pairs = orderPairs(human().landmarks, human().trueMap());
  ASSERT_GE(pairs.sources.size(), 20U);
  ASSERT_EQ(pairs.sources.size(), pairs.targets.size());
  const int side = trueSide(pairs.sources[0]);
  EXPECT_NE(side, 0);
  for (std::size_t k = 0; k < pairs.sources.size(); ++k) {
    EXPECT_EQ(trueSide(pairs.sources[k]), side) << k;
    EXPECT_EQ(trueSide(pairs.targets[k]), -side) << k;
  }
}

TEST(SideVotes, NothingThatMovesNoPairs)
{
  SampleMap identity(human().landmarks.size());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_TRUE(orderPairs(human().landmarks, identity).sources.empty());
}

} // namespace
