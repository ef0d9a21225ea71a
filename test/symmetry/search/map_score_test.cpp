#include "support/human.h"
#include "support/landmark_maps.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/search/map_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

SampleMap
identity(std::size_t size)
{
  SampleMap map(size);
  std::iota(map.begin(), map.end(), 0);
  return map;
}

MapScore
scoreOf(const CoarseBody& body, const SampleMap& map)
{
  const ShapeDescriptor descriptor = describeShape(body.coarse, body.basis, 8, DescriptorWeights{});
  return scoreMap(body.landmarks, descriptor, map, map.size(), ScoreWeights{});
}

/** An ellipsoid of three different axes: three reflections and three half turns. */
const CoarseBody&
ellipsoid()
{
  static const CoarseBody body = [] {
    CoarseBody result;
    result.surface = preparedMesh(scaled(sphereMesh(5), {1.0F, 0.7F, 0.45F}));
    result.coarse = coarsenSurface(result.surface, 700);
    result.basis = laplacianBasis(result.coarse, 40);
    result.landmarks = makeLandmarkSurface(result.coarse, 250, Metric::Geodesic);
    return result;
  }();
  return body;
}

TEST(MapScore, IdentityKeepsEverythingAndMovesNothing)
{
  const MapScore score = scoreOf(human(), identity(250));
  EXPECT_EQ(score.isometry, 0.0F);
  EXPECT_EQ(score.involution, 0.0F);
  EXPECT_EQ(score.displacement, 0.0F);
  EXPECT_EQ(score.fixed, 1.0F);
  EXPECT_LT(score.reversal, 0.1F); // but for dual triangles that face the wrong way
  EXPECT_EQ(score.curvature, 0.0F);
}

TEST(MapScore, TheTrueMapIsBetterThanIdentityAndThanChance)
{
  const MapScore true_map = scoreOf(human(), human().trueMap());
  EXPECT_LT(true_map.isometry, 0.03F);
  EXPECT_GT(true_map.reversal, 0.65F);
  EXPECT_TRUE(isReflection(true_map));
  EXPECT_LT(true_map.value, scoreOf(human(), identity(250)).value);
  SampleMap shifted(250);
  for (std::size_t i = 0; i < shifted.size(); ++i) {
    shifted[i] = static_cast<Index>((7 * i + 13) % 250);
  }
  const MapScore by_chance = scoreOf(human(), shifted);
  EXPECT_LT(true_map.value, by_chance.value);
  EXPECT_FALSE(isReflection(by_chance));
  EXPECT_LT(scoreConfidence(by_chance), scoreConfidence(true_map));
}

/** Of two maps that move as much on average the one is worse that leaves some where they are. */
TEST(MapScore, WhatMovesFarDoesNotMakeUpForWhatStandsStill)
{
  const CoarseBody& body = human();
  const auto at = [&body](Index i, Index j) {
    return body.landmarks.distances(i, j) / body.landmarks.diameter;
  };
  SampleMap all_move = identity(250);
  SampleMap half_moves = identity(250);
  float moved = 0.0F;
  for (Index i = 0; i < 250; ++i) { // about a fifth and about two fifths of the diameter
    const auto nearest_to = [&](float way) {
      Index found = i;
      for (Index j = 0; j < 250; ++j) {
        found = std::abs(at(i, j) - way) < std::abs(at(i, found) - way) ? j : found;
      }
      return found;
    };
    all_move[i] = nearest_to(0.2F);
    half_moves[i] = i % 2 == 0 ? i : nearest_to(0.4F);
    moved += at(i, all_move[i]) / 250.0F;
  }
  const MapScore even = scoreOf(body, all_move);
  const MapScore uneven = scoreOf(body, half_moves);
  ASSERT_NEAR(even.displacement, moved, 1e-5F);
  ASSERT_NEAR(uneven.displacement, even.displacement, 0.02F);
  EXPECT_NEAR(even.log_displacement, std::log(0.2F), 0.1F);
  EXPECT_LT(uneven.log_displacement, even.log_displacement - 2.0F);
}

TEST(MapScore, HowFarBeyondAFifthOfTheDiameterTellsNothing)
{
  const CoarseBody& body = human();
  SampleMap across(250);
  for (Index i = 0; i < 250; ++i) {
    Eigen::Index farthest = 0;
    body.landmarks.distances.col(i).maxCoeff(&farthest);
    across[i] = static_cast<Index>(farthest);
  }
  const MapScore score = scoreOf(body, across);
  ASSERT_GT(score.displacement, 0.4F);
  EXPECT_NEAR(score.log_displacement, std::log(0.2F + ScoreWeights{}.resolution), 1e-3F);
}

/** Antipodes change places: distances stay, the orientation turns over, and everything moves, but nothing stands still. */
TEST(MapScore, AReflectionHasAnAxis)
{
  const CoarseBody& body = ellipsoid();
  const MapScore reflection = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                        return {p[0], p[1], -p[2]};
                                      }));
  const MapScore antipodes = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                       return {-p[0], -p[1], -p[2]};
                                     }));
  EXPECT_LE(reflection.nearest_image, axis_reach);
  EXPECT_GT(antipodes.nearest_image, axis_reach);
  EXPECT_GT(antipodes.reversal, 0.7F);
  EXPECT_GT(antipodes.log_displacement, reflection.log_displacement + 0.3F);
  EXPECT_LT(reflection.value, antipodes.value);
  EXPECT_FALSE(isReflection(antipodes));
}

/** What cannot be told from standing still counts less against a map where landmarks are far apart. */
TEST(MapScore, TheResolutionBoundsWhatStandingStillCosts)
{
  const CoarseBody& body = human();
  const ShapeDescriptor descriptor = describeShape(body.coarse, body.basis, 8, DescriptorWeights{});
  ScoreWeights weights;
  weights.resolution = 0.1F;
  const SampleMap map = identity(250);
  EXPECT_NEAR(scoreMap(body.landmarks, descriptor, map, map.size(), weights).log_displacement, std::log(0.1F), 1e-5F);
  EXPECT_NEAR(scoreOf(body, map).log_displacement, std::log(ScoreWeights{}.resolution), 1e-4F);
}

TEST(MapScore, AReflectionIsToldFromAHalfTurn)
{
  const CoarseBody& body = ellipsoid();
  const MapScore reflection = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                        return {-p[0], p[1], p[2]};
                                      }));
  const MapScore turn = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                  return {-p[0], -p[1], p[2]};
                                }));
  EXPECT_LT(reflection.isometry, 0.04F);
  EXPECT_LT(turn.isometry, 0.04F);
  EXPECT_GT(reflection.reversal, 0.8F);
  EXPECT_LT(turn.reversal, 0.2F);
  EXPECT_LT(reflection.value, turn.value);
  EXPECT_FALSE(isReflection(turn));
}

TEST(MapScore, OfARotationCountsAReversalAgainstIt)
{
  const CoarseBody& body = ellipsoid();
  const ShapeDescriptor descriptor = describeShape(body.coarse, body.basis, 8, DescriptorWeights{});
  const auto asRotation = [&](const SampleMap& map) {
    return scoreRotation(body.landmarks, descriptor, map, map, ScoreWeights{});
  };
  const SampleMap turn = mapOf(body.landmarks, [](const Vector3& p) -> Vector3 { return {-p[0], -p[1], p[2]}; });
  const SampleMap reflection = mapOf(body.landmarks, [](const Vector3& p) -> Vector3 { return {-p[0], p[1], p[2]}; });
  EXPECT_TRUE(isRotation(asRotation(turn)));
  EXPECT_FALSE(isRotation(asRotation(reflection)));
  EXPECT_LT(asRotation(turn).value, scoreOf(body, turn).value);
  EXPECT_GT(asRotation(reflection).value, scoreOf(body, reflection).value);
}

TEST(MapScore, OfARotationMeasuresTheWayBackByTheInverse)
{
  const CoarseBody& body = human();
  const ShapeDescriptor descriptor = describeShape(body.coarse, body.basis, 8, DescriptorWeights{});
  SampleMap shifted(250);
  SampleMap inverse(250);
  for (std::size_t i = 0; i < shifted.size(); ++i) {
    shifted[i] = static_cast<Index>((i + 13) % 250);
    inverse[shifted[i]] = static_cast<Index>(i);
  }
  EXPECT_EQ(scoreRotation(body.landmarks, descriptor, shifted, inverse, ScoreWeights{}).involution, 0.0F);
  EXPECT_GT(scoreRotation(body.landmarks, descriptor, shifted, shifted, ScoreWeights{}).involution, 0.1F);
}

TEST(MapScore, FindsOutWhetherAMapHasAnAxis)
{
  const CoarseBody& body = ellipsoid();
  const MapScore reflection = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                        return {-p[0], p[1], p[2]};
                                      }));
  const MapScore in_a_point = scoreOf(body, mapOf(body.landmarks, [](const Vector3& p) -> Vector3 {
                                        return {-p[0], -p[1], -p[2]};
                                      }));
  EXPECT_LT(reflection.nearest_image, 0.06F);
  EXPECT_GT(in_a_point.nearest_image, 0.3F);
}

TEST(MapScore, DoesNotDependOnTheLengthUnit)
{
  CoarseBody larger = human();
  larger.landmarks.distances *= 4.0F;
  larger.landmarks.diameter *= 4.0F;
  for (Vector3& p : larger.landmarks.points) {
    p = 4.0F * p;
  }
  EXPECT_NEAR(scoreOf(larger, human().trueMap()).value, scoreOf(human(), human().trueMap()).value, 1e-4F);
}

TEST(MapDifference, IsTheMeanDistanceOfTheImages)
{
  const SampleMap same = identity(250);
  EXPECT_EQ(mapDifference(human().landmarks, same, same), 0.0F);
  SampleMap other = same;
  other[10] = 20;
  EXPECT_NEAR(mapDifference(human().landmarks, same, other),
              human().landmarks.distances(10, 20) / human().landmarks.diameter / 250.0F, 1e-6F);
}

} // namespace
