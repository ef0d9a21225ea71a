#include "symmetry/samples/cell_members.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;

namespace {

CoarseSurface
cellsOwning(std::vector<Index> owners, std::size_t cells)
{
  CoarseSurface coarse;
  coarse.points.resize(cells);
  coarse.cells.owner = std::move(owners);
  return coarse;
}

TEST(CellMembers, AreThePointsThatACellOwnsAscending)
{
  const CellMembers members = membersOfCells(cellsOwning({2, 0, 2, 0, 0, 2}, 4));
  EXPECT_EQ(members.offsets, (std::vector<std::uint32_t>{0, 3, 3, 6, 6})); // the second and the last own none
  EXPECT_EQ(members.points, (std::vector<Index>{1, 3, 4, 0, 2, 5}));
}

TEST(CellMembers, AreThinnedOutEvenly)
{
  std::vector<Index> owners(10, 0);
  owners.insert(owners.end(), 3, 1);
  const CellMembers members = membersOfCells(cellsOwning(owners, 2));
  const CellMembers thinned = thinnedMembers(members, 4);
  EXPECT_EQ(thinned.offsets, (std::vector<std::uint32_t>{0, 4, 7}));
  EXPECT_EQ(thinned.points, (std::vector<Index>{0, 3, 6, 9, 10, 11, 12}));
}

TEST(CellMembers, NoCellLosesAllAndNoneKeepsTooMany)
{
  for (std::uint32_t size = 1; size < 40; ++size) {
    const CellMembers members = membersOfCells(cellsOwning(std::vector<Index>(size, 0), 1));
    for (std::uint32_t maximum = 1; maximum < 12; ++maximum) {
      const CellMembers thinned = thinnedMembers(members, maximum);
      EXPECT_GE(thinned.points.size(), 1U);
      EXPECT_LE(thinned.points.size(), maximum);
      EXPECT_TRUE(std::is_sorted(thinned.points.begin(), thinned.points.end()));
    }
  }
}

} // namespace
