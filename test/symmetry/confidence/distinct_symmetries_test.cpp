#include "support/coarse_body.h"
#include "support/landmark_maps.h"
#include "support/symmetric_shapes.h"
#include "support/with_threads.h"
#include "symmetry/confidence/distinct_symmetries.h"
#include "symmetry/confidence/map_confidence.h"

#include <gtest/gtest.h>

#include <array>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct Shape {
  CoarseBody body;
  DistinctSymmetries found;
};

Shape
analyse(const Surface& mesh, std::size_t most = 10)
{
  Shape shape;
  shape.body.surface = preparedMesh(mesh);
  shape.body.coarse = coarsenSurface(shape.body.surface, 1000);
  shape.body.basis = laplacianBasis(shape.body.coarse, 50);
  shape.body.landmarks = withThreads(2, [&] { return makeLandmarkSurface(shape.body.coarse, 400, Metric::Geodesic); });
  const SearchSettings settings;
  const SampledSurface sampled = shape.body.sampled();
  const std::vector<SymmetryCandidate> candidates = searchSymmetries(sampled, settings);
  shape.found = distinctSymmetries(sampled.landmarks, sampled.descriptor, candidates, settings, most);
  return shape;
}

/** Image of every landmark under a mapping of space about the vertical axis: reflected or not in x = 0, then turned. */
SampleMap
rigidMap(const LandmarkSurface& landmarks, bool reflect, double turn)
{
  Vector3 centre{0.0F, 0.0F, 0.0F};
  for (const Vector3& p : landmarks.points) {
    centre = centre + (1.0F / static_cast<float>(landmarks.size())) * p;
  }
  const auto c = static_cast<float>(std::cos(turn));
  const auto s = static_cast<float>(std::sin(turn));
  return mapOf(landmarks, [&](const Vector3& p) {
    const float x = (reflect ? -1.0F : 1.0F) * (p[0] - centre[0]);
    const float z = p[2] - centre[2];
    return Vector3{centre[0] + c * x + s * z, p[1], centre[2] - s * x + c * z};
  });
}

/** How many of the known maps are among the found ones. */
std::size_t
countFound(const LandmarkSurface& landmarks, const std::vector<SampleMap>& known, const std::vector<SampleMap>& found)
{
  constexpr float same = 0.05F;
  return static_cast<std::size_t>(std::count_if(known.begin(), known.end(), [&](const SampleMap& map) {
    return std::any_of(found.begin(), found.end(),
                       [&](const SampleMap& other) { return mapDifference(landmarks, map, other) < same; });
  }));
}

std::vector<SampleMap>
reflectionMaps(const DistinctSymmetries& found)
{
  std::vector<SampleMap> maps;
  for (const DistinctReflection& reflection : found.reflections) {
    maps.push_back(reflection.candidate.map);
  }
  return maps;
}

std::vector<SampleMap>
rotationMaps(const DistinctSymmetries& found)
{
  std::vector<SampleMap> maps;
  for (const DistinctRotation& rotation : found.rotations) {
    maps.push_back(rotation.map);
  }
  return maps;
}

/** The symmetries of a figure with \a order equal parts around the vertical axis, one of them along z: as many
 * reflections, and one rotation less. */
void
expectDihedral(const Shape& shape, int order)
{
  const LandmarkSurface& landmarks = shape.body.landmarks;
  std::vector<SampleMap> reflections;
  std::vector<SampleMap> rotations;
  for (int k = 0; k < order; ++k) {
    reflections.push_back(rigidMap(landmarks, true, full_turn * k / order));
    if (k > 0) {
      rotations.push_back(rigidMap(landmarks, false, full_turn * k / order));
    }
  }
  EXPECT_EQ(shape.found.reflections.size(), reflections.size());
  EXPECT_EQ(shape.found.rotations.size(), rotations.size());
  EXPECT_EQ(countFound(landmarks, reflections, reflectionMaps(shape.found)), reflections.size());
  EXPECT_EQ(countFound(landmarks, rotations, rotationMaps(shape.found)), rotations.size());
}

const Shape&
squareTable()
{
  static const Shape shape = analyse(tableMesh(0.6, 0.6));
  return shape;
}

TEST(DistinctSymmetries, OfASquareTableAreFourReflectionsAndThreeRotations)
{
  expectDihedral(squareTable(), 4);
}

TEST(DistinctSymmetries, OfAnOctopusAreAsManyReflectionsAsItHasArms)
{
  expectDihedral(analyse(octopusMesh(5)), 5);
}

TEST(DistinctSymmetries, OfAMugAndOfGlassesIsOneReflection)
{
  expectDihedral(analyse(mugMesh()), 1);
  expectDihedral(analyse(glassesMesh()), 1);
}

TEST(DistinctSymmetries, OfABoxAreReflectionsWithAnAxisOnly)
{
  const Shape box = analyse(boxMesh());
  // Three reflections; the reflection in the centre keeps no point, half turns keep the orientation.
  EXPECT_EQ(box.found.reflections.size(), 3U);
  EXPECT_EQ(box.found.rotations.size(), 3U);
  for (const DistinctReflection& reflection : box.found.reflections) {
    EXPECT_GT(reflection.candidate.score.reversal, 0.7F);
    EXPECT_LT(reflection.candidate.score.nearest_image, 0.1F);
  }
}

TEST(DistinctSymmetries, AreDistinctBestFirstAndOnTheRightSideOfOrientation)
{
  const DistinctSymmetries& found = squareTable().found;
  const LandmarkSurface& landmarks = squareTable().body.landmarks;
  const float distinct = SearchSettings{}.distinct;
  const std::array<std::vector<SampleMap>, 2> lists{reflectionMaps(found), rotationMaps(found)};
  for (const std::vector<SampleMap>& maps : lists) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(mapDifference(landmarks, maps[i], maps[j]), distinct);
      }
    }
  }
  for (std::size_t i = 1; i < found.reflections.size(); ++i) {
    EXPECT_LE(found.reflections[i - 1].candidate.score.value, found.reflections[i].candidate.score.value);
  }
  for (std::size_t i = 1; i < found.rotations.size(); ++i) {
    EXPECT_LE(found.rotations[i - 1].score.value, found.rotations[i].score.value);
  }
  for (const DistinctReflection& reflection : found.reflections) {
    EXPECT_GT(reflection.candidate.score.reversal, 0.6F);
  }
  for (const DistinctRotation& rotation : found.rotations) {
    EXPECT_LT(rotation.score.reversal, 0.4F);
    EXPECT_NE(rotation.first, rotation.second);
    EXPECT_GE(rotation.score.displacement, distinct);
  }
}

TEST(DistinctSymmetries, AreNoMoreThanAskedFor)
{
  const Shape shape = analyse(tableMesh(0.6, 0.6), 2);
  EXPECT_EQ(shape.found.reflections.size(), 2U);
  EXPECT_LE(shape.found.rotations.size(), 2U);
}

} // namespace
