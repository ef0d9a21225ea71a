#include "support/graphs.h"
#include "support/with_threads.h"
#include "symmetry/sides/sides.h"
#include "symmetry/staged/dense_map.h"
#include "symmetry/staged/stage_matching.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr Index columns = 21;
constexpr Index rows = 12;

/** A rectangle without diagonals, so that left and right are alike to the last bit, and a base of three pairs. */
class StageMatching : public testing::Test {
protected:
  StageMatching() : graph_(rectangle()), metric_(graph_), base_(metric_)
  {
    std::vector<SymmetricMatch> pairs = {match(at(0, 0)), match(at(1, rows - 1)), match(at(4, 5))};
    base_.addPairs(pairs);
    midpoints_ = {pairs[0].midpoint, pairs[1].midpoint, pairs[2].midpoint};
  }

  static SurfaceGraph
  rectangle()
  {
    std::vector<GraphEdge> edges;
    for (Index j = 0; j < rows; ++j) {
      for (Index i = 0; i < columns; ++i) {
        if (i + 1 < columns) {
          edges.push_back({at(i, j), at(i + 1, j), 1.0F});
        }
        if (j + 1 < rows) {
          edges.push_back({at(i, j), at(i, j + 1), 1.0F});
        }
      }
    }
    return buildGraph(static_cast<std::size_t>(columns * rows), edges);
  }

  static Index
  at(Index i, Index j)
  {
    return j * columns + i;
  }

  static Index
  mirrored(Index v)
  {
    return at(columns - 1 - v % columns, v / columns);
  }

  static SymmetricMatch
  match(Index source)
  {
    return {source, mirrored(source), no_index, 0.0F};
  }

  /** Left and right limbs of the upper and the lower half, and a centre. */
  static std::vector<Region>
  regions()
  {
    std::vector<Region> regions(static_cast<std::size_t>(columns * rows), Region::Centre);
    for (Index v = 0; v < columns * rows; ++v) {
      const bool upper = v / columns >= rows / 2;
      if (v % columns < 7) {
        regions[v] = upper ? Region::Source2 : Region::Source1;
      }
      if (v % columns >= columns - 7) {
        regions[v] = upper ? Region::Target2 : Region::Target1;
      }
    }
    return regions;
  }

  SurfaceGraph graph_;
  GeodesicMetric metric_;
  BaseVertices base_;
  std::vector<Index> midpoints_;
};

} // namespace

TEST_F(StageMatching, FeaturesAreTheDistancesToOwnEndsThenToMidpoints)
{
  EXPECT_EQ(base_.dimensions(), 6U);
  const std::vector<Index> vertices = {at(3, 3), at(20, 7)};
  const FeatureVectors source = base_.features(vertices, Side::Source, FeatureSet::OwnEndpointsAndMidpoints);
  const FeatureVectors target = base_.features(vertices, Side::Target, FeatureSet::OwnEndpointsAndMidpoints);
  const FeatureVectors middle = base_.features(vertices, Side::Source, FeatureSet::Midpoints);
  ASSERT_EQ(source.dimensions, 6U);
  ASSERT_EQ(middle.dimensions, 3U);
  const std::vector<Index> ends = {at(0, 0), at(1, rows - 1), at(4, 5)};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::vector<float> field = distanceField(graph_, vertices[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(source.row(i)[k], field[ends[k]]);
      EXPECT_EQ(target.row(i)[k], field[mirrored(ends[k])]);
      EXPECT_EQ(source.row(i)[3 + k], field[midpoints_[k]]);
      EXPECT_EQ(target.row(i)[3 + k], field[midpoints_[k]]);
      EXPECT_EQ(middle.row(i)[k], field[midpoints_[k]]);
    }
  }
  // The farthest vertex from (0, 0) is 31 steps away.
  EXPECT_FLOAT_EQ(base_.floors(Side::Source, FeatureSet::OwnEndpointsAndMidpoints)[0], 0.02F * 31.0F);
}

TEST_F(StageMatching, MidpointsAreHalfWay)
{
  for (const Index midpoint : midpoints_) {
    EXPECT_EQ(midpoint % columns, columns / 2);
  }
}

TEST_F(StageMatching, FindsTheMirrorVertices)
{
  Matchable vertices;
  for (Index v = 0; v < columns * rows; ++v) {
    (v % columns < columns / 2 ? vertices.queries : vertices.candidates).push_back(v);
  }
  const std::vector<SymmetricMatch> matches = withThreads(
      2, [&] { return matchVertices(base_, vertices, Side::Source, FeatureSet::OwnEndpointsAndMidpoints); });
  ASSERT_EQ(matches.size(), vertices.queries.size());
  for (const SymmetricMatch& match : matches) {
    EXPECT_EQ(match.target, mirrored(match.source));
    EXPECT_EQ(match.cost, 0.0F);
  }
  // Queries of the target side are turned round.
  const std::vector<SymmetricMatch> back =
      matchVertices(base_, {{at(18, 2)}, vertices.queries}, Side::Target, FeatureSet::OwnEndpointsAndMidpoints);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].source, at(2, 2));
  EXPECT_EQ(back[0].target, at(18, 2));
}

TEST_F(StageMatching, MatchesNothingWithoutCandidatesOrQueries)
{
  EXPECT_TRUE(matchVertices(base_, {{1, 2, 3}, {}}, Side::Source, FeatureSet::Midpoints).empty());
  EXPECT_TRUE(matchVertices(base_, {{}, {1, 2, 3}}, Side::Source, FeatureSet::Midpoints).empty());
  EXPECT_TRUE(matchExtremities(base_, regions(), {at(2, 2)}, 5).empty()); // no extremity on the other side
}

TEST_F(StageMatching, MatchesExtremitiesWithinTheirPairOfLimbs)
{
  const std::vector<Index> extremities = {at(2, 1),           at(5, 3),           at(1, 8),
                                          mirrored(at(2, 1)), mirrored(at(5, 3)), mirrored(at(1, 8))};
  const std::vector<SymmetricMatch> matches = matchExtremities(base_, regions(), extremities, 5);
  ASSERT_EQ(matches.size(), 3U);
  for (const SymmetricMatch& match : matches) {
    EXPECT_EQ(match.target, mirrored(match.source));
  }
  EXPECT_EQ(matchExtremities(base_, regions(), extremities, 1).size(), 2U); // one per pair of limbs
}

TEST_F(StageMatching, MatchesSamplesOfLimbsAndCentreAcrossTheSides)
{
  const std::vector<float> sides = sideFunction(base_.sourceFields(), base_.targetFields());
  const std::vector<Index> samples = {at(3, 3), at(6, 9), at(8, 4), at(12, 6), at(9, 9)};
  const std::vector<SymmetricMatch> matches =
      matchSamples(base_, regions(), sides, samples, FeatureSet::OwnEndpointsAndMidpoints, 30);
  ASSERT_EQ(matches.size(), samples.size());
  for (const SymmetricMatch& match : matches) {
    EXPECT_EQ(match.target, mirrored(match.source));
    EXPECT_LT(match.source % columns, columns / 2);
  }
  EXPECT_EQ(matchSamples(base_, regions(), sides, samples, FeatureSet::Midpoints, 1).size(), 3U); // one per mapping
}

TEST_F(StageMatching, TheDenseMapOfAMirrorSymmetricSurfaceIsTheMirror)
{
  const std::vector<float> sides = absorbSpecks(graph_, sideFunction(base_.sourceFields(), base_.targetFields()));
  const DenseMap map = withThreads(2, [&] { return denseMap(base_, sides); });
  for (Index v = 0; v < columns * rows; ++v) {
    if (v % columns != columns / 2) { // the middle column has to go to a side
      EXPECT_EQ(map.partners[v], mirrored(v));
      EXPECT_EQ(map.dissimilarities[v], 0.0F);
    }
  }
  EXPECT_EQ(denseMap(base_, sides).partners, map.partners);
}

TEST_F(StageMatching, TheDenseMapIsEmptyWhereThereIsOneSideOnly)
{
  const DenseMap map = denseMap(base_, std::vector<float>(static_cast<std::size_t>(columns * rows), 1.0F));
  EXPECT_EQ(map.partners, std::vector<Index>(static_cast<std::size_t>(columns * rows), no_index));
}

TEST(Cheapest, AreOrderedByCostThenBySource)
{
  const std::vector<SymmetricMatch> matches =
      cheapest({{5, 1, 0, 2.0F}, {3, 1, 0, 1.0F}, {2, 1, 0, 2.0F}, {9, 1, 0, 0.5F}}, 3);
  ASSERT_EQ(matches.size(), 3U);
  EXPECT_EQ(matches[0].source, 9);
  EXPECT_EQ(matches[1].source, 3);
  EXPECT_EQ(matches[2].source, 2);
  EXPECT_TRUE(cheapest({}, 3).empty());
}

TEST(Within, KeepsTheOrderOfTheList)
{
  const std::vector<Region> regions = {Region::Centre, Region::Source1, Region::Centre, Region::Source1};
  EXPECT_EQ(within({3, 0, 1}, regions, Region::Source1), (std::vector<Index>{3, 1}));
  EXPECT_EQ(verticesOf(regions, Region::Centre), (std::vector<Index>{0, 2}));
  EXPECT_TRUE(verticesOf(regions, Region::Target2).empty());
}
