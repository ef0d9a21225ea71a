#include "base/union_find.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

TEST(UnionFind, JoinsSetsAndKnowsThemByTheirLowestPoint)
{
  UnionFind sets(7);
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_TRUE(sets.join(5, 6));
  EXPECT_FALSE(sets.join(3, 6));
  EXPECT_EQ(sets.find(6), 3);
  EXPECT_EQ(sets.find(4), 4);
  EXPECT_EQ(sets.largest(), 3);
}

TEST(UnionFind, OfTwoLargestSetsTheFirstCounts)
{
  UnionFind sets(4);
  sets.join(2, 3);
  sets.join(1, 0);
  EXPECT_EQ(sets.largest(), 0);
  EXPECT_EQ(UnionFind(0).largest(), no_index);
}

} // namespace
