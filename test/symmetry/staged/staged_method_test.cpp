#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "model/articulated_body.h"
#include "support/prepared.h"
#include "support/with_threads.h"
#include "symmetry/staged/staged_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct KnownBody {
  Model model;
  PreparedSurface surface;
};

/** A body, with its largest coordinate at one half. */
KnownBody
body(Body kind, double bend, std::uint64_t seed)
{
  ModelParameters parameters;
  parameters.body = kind;
  parameters.vertices = 3000;
  parameters.bend = bend;
  parameters.seed = seed;
  KnownBody body;
  body.model = makeModel(parameters);
  float largest = 0.0F;
  for (const Vector3& p : body.model.surface.points) {
    for (const float x : p) {
      largest = std::max(largest, std::abs(x));
    }
  }
  for (Vector3& p : body.model.surface.points) {
    p = (0.5F / largest) * p;
  }
  body.surface = prepared(body.model.surface);
  return body;
}

MapEstimate
estimate(const PreparedSurface& surface, const SymmetryParameters& parameters = {})
{
  StepTimer timer;
  return estimateStaged(surface, parameters, timer);
}

/** Share of some vertices whose partner is within 8 % of the diameter of the true one. */
double
rate(const KnownBody& body, const MapEstimate& found)
{
  std::size_t right = 0;
  std::size_t all = 0;
  for (std::size_t v = 0; v < body.surface.size(); v += 29) {
    if (body.model.partners[v] != no_index) {
      ++all;
      right += distanceField(body.surface.graph, body.model.partners[v])[found.partners[v]] < 0.08F * found.diameter;
    }
  }
  return static_cast<double>(right) / static_cast<double>(all);
}

/** Share of vertices for which the two maps have partners within 2 % of the diameter (in space). */
double
agreement(const PreparedSurface& surface, const std::vector<Index>& a, const std::vector<Index>& b, float diameter)
{
  std::size_t same = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    same += distance(surface.points[a[v]], surface.points[b[v]]) < 0.02F * diameter ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(surface.size());
}

/** Everything is a number, in its range, and an index of the surface. */
void
expectSound(const MapEstimate& found, std::size_t n)
{
  const auto is_vertex = [n](Index v) {
    return v >= 0 && v < static_cast<Index>(n);
  };
  EXPECT_TRUE(found.confidence >= 0.0F && found.confidence <= 1.0F);
  EXPECT_TRUE((found.status == SymmetryStatus::Symmetric) == found.message.empty()) << found.message;
  for (const Index partner : found.partners) {
    EXPECT_TRUE(partner == no_index || is_vertex(partner));
  }
  for (const float confidence : found.confidences) {
    EXPECT_TRUE(confidence >= 0.0F && confidence <= 1.0F);
  }
  for (const float side : found.side_function) {
    EXPECT_TRUE(side >= -1.0F && side <= 1.0F && side != 0.0F);
  }
  for (const SymmetricMatch& match : found.matches) {
    EXPECT_TRUE(is_vertex(match.source) && is_vertex(match.target) && is_vertex(match.midpoint));
    EXPECT_TRUE(std::isfinite(match.cost) && match.cost >= 0.0F);
  }
  if (found.status == SymmetryStatus::Symmetric) {
    EXPECT_EQ(found.side_function.size(), n);
    EXPECT_EQ(found.regions.size(), n);
    EXPECT_EQ(found.extremities.size(), 4U);
    EXPECT_GT(found.diameter, 0.0F);
  }
}

/** Every match runs from the source to the target side. */
void
expectMatchesAcross(const MapEstimate& found)
{
  for (const SymmetricMatch& match : found.matches) {
    EXPECT_GT(found.side_function[match.source], found.side_function[match.target]);
  }
}

void
expectEqual(const MapEstimate& a, const MapEstimate& b)
{
  EXPECT_EQ(a.partners, b.partners);
  EXPECT_EQ(a.confidences, b.confidences);
  EXPECT_EQ(a.side_function, b.side_function);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.extremities, b.extremities);
  EXPECT_EQ(a.confidence, b.confidence);
  ASSERT_EQ(a.matches.size(), b.matches.size());
  for (std::size_t i = 0; i < a.matches.size(); ++i) {
    EXPECT_EQ(a.matches[i].source, b.matches[i].source);
    EXPECT_EQ(a.matches[i].target, b.matches[i].target);
    EXPECT_EQ(a.matches[i].midpoint, b.matches[i].midpoint);
    EXPECT_EQ(a.matches[i].cost, b.matches[i].cost);
  }
}

} // namespace

TEST(StagedMethod, FindsTheMirrorPartnersOfABodyAtRest)
{
  const KnownBody human = body(Body::Human, 0.0, 1);
  const MapEstimate found = estimate(human.surface);
  ASSERT_EQ(found.status, SymmetryStatus::Symmetric);
  expectSound(found, human.surface.size());
  EXPECT_GE(rate(human, found), 0.97);
  EXPECT_GT(found.confidence, 0.8F);
  EXPECT_GE(found.matches.size(), 60U);
}

TEST(StagedMethod, FindsThePartnersOfBentBodies)
{
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    const KnownBody human = body(Body::Human, 1.0, seed);
    const MapEstimate found = estimate(human.surface);
    ASSERT_EQ(found.status, SymmetryStatus::Symmetric) << found.message;
    expectSound(found, human.surface.size());
    expectMatchesAcross(found);
    EXPECT_GE(rate(human, found), 0.9) << "seed " << seed;
  }
}

TEST(StagedMethod, FindsThePawsOfAnimalsUnlessTheFirstFourPointsAreAskedFor)
{
  const KnownBody animal = body(Body::Quadruped, 1.0, 1);
  const MapEstimate found = estimate(animal.surface);
  ASSERT_EQ(found.status, SymmetryStatus::Symmetric) << found.message;
  EXPECT_GE(rate(animal, found), 0.9);
  SymmetryParameters literally;
  literally.staged.extremities = ExtremePoints::FirstFour;
  EXPECT_NE(estimate(animal.surface, literally).status, SymmetryStatus::Symmetric);
}

TEST(StagedMethod, PairsLimbsAndPutsTheSidesWhereTheyAre)
{
  const KnownBody human = body(Body::Human, 0.5, 2);
  const MapEstimate found = estimate(human.surface);
  for (std::size_t pair = 0; pair < 4; pair += 2) {
    const Index truth = human.model.partners[found.extremities[pair]];
    EXPECT_LT(distanceField(human.surface.graph, truth)[found.extremities[pair + 1]], 0.08F * found.diameter);
    EXPECT_GT(found.side_function[found.extremities[pair]], 0.0F);
    EXPECT_LT(found.side_function[found.extremities[pair + 1]], 0.0F);
  }
  EXPECT_EQ(found.regions[found.extremities[0]], Region::Source1);
  EXPECT_EQ(found.regions[found.extremities[1]], Region::Target1);
  EXPECT_EQ(found.regions[found.extremities[2]], Region::Source2);
  EXPECT_EQ(found.regions[found.extremities[3]], Region::Target2);
  std::size_t opposite = 0;
  for (std::size_t v = 0; v < human.surface.size(); ++v) {
    opposite += found.side_function[v] * found.side_function[human.model.partners[v]] < 0.0F ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(opposite), 0.9 * static_cast<double>(human.surface.size()));
}

TEST(StagedMethod, IsTheSameForAnyNumberOfThreads)
{
  const KnownBody human = body(Body::Human, 1.0, 7);
  const MapEstimate one = estimate(human.surface);
  for (const unsigned threads : {2U, 5U}) {
    expectEqual(withThreads(threads, [&] { return estimate(human.surface); }), one);
  }
}

TEST(StagedMethod, DoesNotDependOnTheOrderOfTheVertices)
{
  const KnownBody human = body(Body::Human, 1.0, 4);
  std::vector<Index> new_number(human.surface.size());
  std::iota(new_number.begin(), new_number.end(), 0);
  std::shuffle(new_number.begin(), new_number.end(), std::mt19937(5));
  const MapEstimate found = estimate(human.surface);
  const MapEstimate shuffled = estimate(prepared(renumbered(human.model.surface, new_number)));
  std::vector<Index> back(human.surface.size());
  std::vector<Index> old_number(human.surface.size());
  for (std::size_t v = 0; v < back.size(); ++v) {
    old_number[new_number[v]] = static_cast<Index>(v);
  }
  for (std::size_t v = 0; v < back.size(); ++v) {
    back[v] = old_number[shuffled.partners[new_number[v]]];
  }
  // Not every vertex: ties (and paths of equal length) go to the lowest number.
  EXPECT_GE(agreement(human.surface, found.partners, back, found.diameter), 0.95);
}

TEST(StagedMethod, DoesNotDependOnPositionSizeOrHandedness)
{
  const KnownBody human = body(Body::Human, 1.0, 5);
  const MapEstimate found = estimate(human.surface);
  Surface moved = human.model.surface;
  for (Vector3& p : moved.points) {
    p = {3.0F - 2.0F * p[1], 2.0F * p[0] + 1.0F, 2.0F * p[2]}; // a quarter turn, twice the size
  }
  const MapEstimate of_moved = estimate(prepared(moved));
  EXPECT_GE(agreement(human.surface, found.partners, of_moved.partners, found.diameter), 0.95);
  EXPECT_NEAR(of_moved.diameter, 2.0F * found.diameter, 1e-3F);
  const MapEstimate mirrored = estimate(prepared(scaled(human.model.surface, {-1.0F, 1.0F, 1.0F})));
  expectEqual(mirrored, found); // nothing in the method knows left from right
}

TEST(StagedMethod, LeavesOutTheDenseMapOnRequest)
{
  const KnownBody human = body(Body::Human, 1.0, 4);
  SymmetryParameters parameters;
  parameters.sparse_only = true;
  const MapEstimate sparse = estimate(human.surface, parameters);
  const MapEstimate dense = estimate(human.surface);
  EXPECT_TRUE(sparse.partners.empty());
  EXPECT_TRUE(sparse.confidences.empty());
  EXPECT_EQ(sparse.side_function, dense.side_function);
  EXPECT_EQ(sparse.matches.size(), dense.matches.size());
  expectSound(sparse, human.surface.size());
}

TEST(StagedMethod, MeasuresStraightLinesOnRequest)
{
  const KnownBody human = body(Body::Human, 0.0, 1);
  SymmetryParameters parameters;
  parameters.metric = Metric::Euclidean;
  const MapEstimate found = estimate(human.surface, parameters);
  ASSERT_EQ(found.status, SymmetryStatus::Symmetric) << found.message;
  expectSound(found, human.surface.size());
  EXPECT_GE(rate(human, found), 0.9);
  EXPECT_LT(found.diameter, estimate(human.surface).diameter);
}

TEST(StagedMethod, SaysSoWhereItsLimbsAreNoPairs)
{
  const KnownBody body_without_leg = body(Body::MissingLeg, 1.0, 1);
  SymmetryParameters literally;
  literally.staged.extremities = ExtremePoints::FirstFour;
  const MapEstimate found = estimate(body_without_leg.surface, literally);
  EXPECT_EQ(found.status, SymmetryStatus::NoSymmetry);
  EXPECT_LT(found.confidence, 0.2F);
  expectSound(found, body_without_leg.surface.size());
}

TEST(StagedMethod, NeedsTwentyPoints)
{
  const MapEstimate found = estimate(prepared(gridMesh(3, 5)));
  EXPECT_EQ(found.status, SymmetryStatus::TooFewPoints);
  EXPECT_NE(found.message.find("15"), std::string::npos);
  EXPECT_EQ(estimate(PreparedSurface{}).status, SymmetryStatus::TooFewPoints);
}

TEST(StagedMethod, SurvivesSurfacesWithoutLimbs)
{
  Surface one_place = gridMesh(6, 6);
  for (Vector3& p : one_place.points) {
    p = {0.25F, 0.25F, 0.25F};
  }
  Surface two_places = gridMesh(6, 6);
  for (std::size_t v = 0; v < 36; ++v) {
    two_places.points[v] = {v < 18 ? 0.0F : 1.0F, 0.0F, 0.0F};
  }
  for (const Metric metric : {Metric::Geodesic, Metric::Euclidean}) {
    for (const Surface& mesh :
         {sphereMesh(1), sphereMesh(3), gridMesh(5, 4), gridMesh(40, 3), gridMesh(20, 20),
          torusMesh(30, 10, 2.0F, 0.5F), scaled(sphereMesh(2), {1.0F, 0.0F, 0.0F}), one_place, two_places}) {
      SymmetryParameters parameters;
      parameters.metric = metric;
      const MapEstimate found = estimate(prepared(mesh), parameters);
      expectSound(found, mesh.size());
    }
  }
}

TEST(StagedMethod, TakesItsParameters)
{
  const KnownBody human = body(Body::Human, 0.5, 3);
  for (const PairingFeature pairing : {PairingFeature::MinimalGeodesicDistance, PairingFeature::BySurfaceSize}) {
    SymmetryParameters parameters;
    parameters.staged.pairing = pairing;
    parameters.staged.extremities = ExtremePoints::FirstFour;
    expectSound(estimate(human.surface, parameters), human.surface.size());
  }
  SymmetryParameters few;
  few.staged.landmarks = 10;
  few.staged.samples = 20;
  few.staged.embedding_dimensions = 20;
  const MapEstimate found = estimate(human.surface, few);
  expectSound(found, human.surface.size());
  EXPECT_LE(found.matches.size(), 20U);
}

TEST(StagedMethod, NamesItsStepsAndCanBeCancelled)
{
  const KnownBody human = body(Body::Human, 0.0, 1);
  StepTimer timer;
  estimateStaged(human.surface, {}, timer);
  std::vector<std::string> steps;
  for (const auto& [name, seconds] : timer.seconds()) {
    steps.push_back(name);
    EXPECT_GE(seconds, 0.0);
  }
  EXPECT_EQ(steps, (std::vector<std::string>{"sampling", "geodesics", "embedding", "hypotheses", "matching", "dense"}));

  StepTimer cancelling([](const char* step, double) { return std::string(step) != "matching"; });
  EXPECT_THROW(estimateStaged(human.surface, {}, cancelling), Cancelled);
}
