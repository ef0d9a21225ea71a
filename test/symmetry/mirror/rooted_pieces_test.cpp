// Pieces that a plane does not carry onto a surface: rooted alike on both sides, or on one.
#include "symmetry/mirror/rooted_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;

namespace {

constexpr float spacing = 0.05F;
constexpr int across = 41; // a square sheet around the origin
constexpr float least_share = 0.005F;

const PlaneReflection plane{{1.0F, 0.0F, 0.0F}, 0.0F};

CoarseSurface
sheet()
{
  CoarseSurface coarse;
  std::vector<std::vector<Index>> adjacent;
  for (int y = 0; y < across; ++y) {
    for (int x = 0; x < across; ++x) {
      coarse.points.push_back(
          {spacing * static_cast<float>(x - across / 2), spacing * static_cast<float>(y - across / 2), 0.0F});
      coarse.areas.push_back(1.0F / static_cast<float>(across * across));
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (x + dx >= 0 && x + dx < across && y + dy >= 0 && y + dy < across) {
          coarse.graph.neighbours.push_back(static_cast<Index>((y + dy) * across + x + dx));
          coarse.graph.lengths.push_back(spacing);
        }
      }
      coarse.graph.offsets.push_back(static_cast<std::uint32_t>(coarse.graph.neighbours.size()));
    }
  }
  return coarse;
}

/** Marks the samples of a disc. */
void
markDisc(const CoarseSurface& coarse, float x, float y, float radius, std::vector<char>& marks)
{
  marks.resize(coarse.size(), 0);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    if (std::hypot(coarse.points[i][0] - x, coarse.points[i][1] - y) < radius) {
      marks[i] = 1;
    }
  }
}

TEST(RootedPieces, WhatStandsInThePlaneIsRootedAlike)
{
  const CoarseSurface coarse = sheet();
  std::vector<char> is_off;
  markDisc(coarse, 0.0F, 0.3F, 0.2F, is_off);
  EXPECT_TRUE(areRootedAlike(coarse, is_off, plane, least_share));
  is_off.assign(coarse.size(), 0);
  markDisc(coarse, 0.05F, 0.3F, 0.2F, is_off); // a little askew
  EXPECT_TRUE(areRootedAlike(coarse, is_off, plane, least_share));
}

TEST(RootedPieces, WhatStandsOnOneSideIsNot)
{
  const CoarseSurface coarse = sheet();
  std::vector<char> is_off;
  markDisc(coarse, 0.4F, 0.0F, 0.2F, is_off);
  EXPECT_FALSE(areRootedAlike(coarse, is_off, plane, least_share));
  markDisc(coarse, 0.0F, 0.7F, 0.2F, is_off); // beside one that stands in the plane
  EXPECT_FALSE(areRootedAlike(coarse, is_off, plane, least_share));
}

TEST(RootedPieces, TwoThatStandOppositeEachOtherAreRootedAlike)
{
  const CoarseSurface coarse = sheet();
  std::vector<char> is_off;
  markDisc(coarse, 0.5F, 0.2F, 0.2F, is_off);
  markDisc(coarse, -0.5F, 0.2F, 0.2F, is_off);
  EXPECT_TRUE(areRootedAlike(coarse, is_off, plane, least_share));
  is_off.assign(coarse.size(), 0);
  markDisc(coarse, 0.5F, 0.6F, 0.2F, is_off);
  markDisc(coarse, -0.5F, -0.6F, 0.2F, is_off);
  EXPECT_FALSE(areRootedAlike(coarse, is_off, plane, least_share));
}

TEST(RootedPieces, SmallOnesAreOverlookedAndFloatingOnesAreNotRooted)
{
  CoarseSurface coarse = sheet();
  std::vector<char> is_off;
  markDisc(coarse, 0.0F, 0.3F, 0.2F, is_off);
  markDisc(coarse, 0.8F, 0.0F, 1.1F * spacing, is_off); // five samples
  EXPECT_TRUE(areRootedAlike(coarse, is_off, plane, least_share));
  EXPECT_FALSE(areRootedAlike(coarse, is_off, plane, 0.002F));
  EXPECT_FALSE(areRootedAlike(coarse, std::vector<char>(coarse.size(), 0), plane, least_share)) << "nothing is off";
  EXPECT_FALSE(areRootedAlike(coarse, std::vector<char>(coarse.size(), 1), plane, least_share)) << "nothing else";
}

} // namespace
