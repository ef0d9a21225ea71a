#include "geodesic/shortest_paths.h"
#include "mesh_checks.h"
#include "model/articulated_body.h"
#include "model/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

ModelParameters
parametersOf(Body body, std::size_t vertices, double bend = 1.0, std::uint64_t seed = 1)
{
  ModelParameters parameters;
  parameters.body = body;
  parameters.vertices = vertices;
  parameters.bend = bend;
  parameters.seed = seed;
  return parameters;
}

std::size_t
index(Index vertex)
{
  return static_cast<std::size_t>(vertex);
}

Vector3
mirrored(const Vector3& point)
{
  return {-point[0], point[1], point[2]};
}

double
distance(const Vector3& a, const Vector3& b)
{
  return std::hypot(static_cast<double>(a[0] - b[0]), static_cast<double>(a[1] - b[1]),
                    static_cast<double>(a[2] - b[2]));
}

/** \brief Per vertex: how many of its edges are edges between the partners as well; over all edges. */
double
shareOfMirroredEdges(const Model& model)
{
  const SurfaceGraph graph = buildMeshGraph(model.surface.points, model.surface.triangles);
  std::size_t mirrored_edges = 0;
  for (std::size_t v = 0; v < graph.size(); ++v)
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      mirrored_edges += areNeighbours(graph, model.partners[v], model.partners[index(graph.neighbours[e])]) ? 1 : 0;
  return static_cast<double>(mirrored_edges) / static_cast<double>(graph.neighbours.size());
}

/** \brief Mean of |d (p, q) - d (s (p), s (q))| / d (p, q) over pairs of random points. */
double
meanChangeUnderTheMap(const Model& model)
{
  constexpr int samples = 40;
  RandomNumbers random(5);
  std::vector<Index> points;
  std::vector<Index> partners;
  for (int i = 0; i < samples; ++i) {
    points.push_back(static_cast<Index>(random.index(model.surface.size())));
    partners.push_back(model.partners[index(points.back())]);
  }
  const SurfaceGraph graph = buildMeshGraph(model.surface.points, model.surface.triangles);
  const DistanceFields here = distanceFields(graph, points);
  const DistanceFields there = distanceFields(graph, partners);
  double sum = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto before = static_cast<double>(here.row(i)[index(points[j])]);
      const auto after = static_cast<double>(there.row(i)[index(partners[j])]);
      if (before == 0.0)
        continue;
      sum += std::abs(after - before) / before;
      ++pairs;
    }
  return sum / pairs;
}

class EveryBody : public testing::TestWithParam<Body> {};
class SymmetricBody : public EveryBody {};
class GrownBody : public EveryBody {}; // all but terrain, which is a grid

std::vector<Body>
bodiesThat(bool (*condition)(Body))
{
  std::vector<Body> bodies;
  std::copy_if(allBodies().begin(), allBodies().end(), std::back_inserter(bodies), condition);
  return bodies;
}

bool
isGrown(Body body)
{
  return body != Body::Terrain;
}

std::string
testName(const testing::TestParamInfo<Body>& info)
{
  std::string name = toString(info.param);
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

TEST_P(EveryBody, IsAnOrientedManifoldOfTheWantedSize)
{
  for (const std::size_t vertices : {std::size_t{1000}, std::size_t{6000}}) {
    const Model model = makeModel(parametersOf(GetParam(), vertices));
    EXPECT_EQ(model.partners.size(), model.surface.size());
    EXPECT_NEAR(static_cast<double>(model.surface.size()), static_cast<double>(vertices),
                GetParam() == Body::Terrain ? 0.02 * static_cast<double>(vertices) : 1.0);
    const Topology topology = topologyOf(model.surface.size(), model.surface.triangles);
    EXPECT_TRUE(topology.oriented_manifold);
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.euler, GetParam() == Body::Terrain ? 1 : 2);
    EXPECT_EQ(topology.boundary_edges > 0, GetParam() == Body::Terrain);
    if (GetParam() != Body::Terrain) {
      EXPECT_GT(volumeOf(toMesh(model.surface)), 0.0); // triangles face outwards
    }
  }
}

TEST_P(EveryBody, HasTheTruthOfItsKind)
{
  const Model model = makeModel(parametersOf(GetParam(), 3000));
  std::size_t axis = 0;
  for (std::size_t v = 0; v < model.partners.size(); ++v) {
    if (!isSymmetric(GetParam())) {
      ASSERT_EQ(model.partners[v], no_index);
      continue;
    }
    ASSERT_NE(model.partners[v], no_index);
    ASSERT_EQ(model.partners[index(model.partners[v])], static_cast<Index>(v));
    axis += model.partners[v] == static_cast<Index>(v) ? 1 : 0;
  }
  EXPECT_EQ(axis > 20, isSymmetric(GetParam()));
}

TEST_P(SymmetricBody, RestPoseIsItsOwnMirrorImageToTheLastBit)
{
  const Model model = makeModel(parametersOf(GetParam(), 3000, 0.0));
  for (std::size_t v = 0; v < model.partners.size(); ++v)
    ASSERT_EQ(mirrored(model.surface.points[v]), model.surface.points[index(model.partners[v])]);
}

TEST_P(SymmetricBody, BendingKeepsLengthsNearlyButPosesLeftAndRightApart)
{
  for (const std::uint64_t seed : {1U, 2U}) {
    const Model model = makeModel(parametersOf(GetParam(), 5000, 1.0, seed));
    EXPECT_LT(meanChangeUnderTheMap(model), 0.06);
    double apart = 0.0;
    for (std::size_t v = 0; v < model.partners.size(); ++v)
      apart =
          std::max(apart, distance(mirrored(model.surface.points[v]), model.surface.points[index(model.partners[v])]));
    EXPECT_GT(apart, 0.2); // of about 2 that the bodies measure
  }
}

TEST_P(GrownBody, TrianglesAreWellShaped)
{
  ModelParameters parameters = parametersOf(GetParam(), 6000);
  parameters.retriangulate = 0.0;
  const std::vector<double> angles = smallestAngles(toMesh(makeModel(parameters).surface));
  EXPECT_GT(angles[angles.size() / 100], 20.0);
  EXPECT_GT(angles[angles.size() / 2], 45.0);
}

TEST_P(EveryBody, SameParametersGiveTheSameBytes)
{
  const Model first = makeModel(parametersOf(GetParam(), 2000, 1.0, 7));
  const Model second = makeModel(parametersOf(GetParam(), 2000, 1.0, 7));
  const Model other = makeModel(parametersOf(GetParam(), 2000, 1.0, 8));
  EXPECT_EQ(first.surface.points, second.surface.points);
  EXPECT_EQ(first.surface.triangles, second.surface.triangles);
  EXPECT_EQ(first.partners, second.partners);
  EXPECT_NE(first.surface.points, other.surface.points);
}

TEST_P(EveryBody, IsFoundByItsName)
{
  EXPECT_EQ(bodyFromName(toString(GetParam())), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Models, EveryBody, testing::ValuesIn(allBodies()), testName);
INSTANTIATE_TEST_SUITE_P(Models, SymmetricBody, testing::ValuesIn(bodiesThat(isSymmetric)), testName);
INSTANTIATE_TEST_SUITE_P(Models, GrownBody, testing::ValuesIn(bodiesThat(isGrown)), testName);

TEST(MakeModel, RetriangulationMakesTheHalvesDiffer)
{
  ModelParameters parameters = parametersOf(Body::Human, 5000);
  parameters.retriangulate = 0.0;
  const Model alike = makeModel(parameters);
  EXPECT_EQ(shareOfMirroredEdges(alike), 1.0);
  parameters.retriangulate = 0.3;
  const Model different = makeModel(parameters);
  EXPECT_LT(shareOfMirroredEdges(different), 0.95);
  EXPECT_GT(shareOfMirroredEdges(different), 0.5);
  EXPECT_EQ(different.surface.points, alike.surface.points);
  EXPECT_EQ(different.partners, alike.partners);
}

TEST(MakeModel, JitterSlidesTheRightHalfWithinItsBound)
{
  ModelParameters parameters = parametersOf(Body::Quadruped, 4000, 0.0);
  const Model exact = makeModel(parameters);
  parameters.jitter = 0.3;
  const Model jittered = makeModel(parameters);
  const SurfaceGraph graph = buildMeshGraph(exact.surface.points, exact.surface.triangles);
  const float longest = *std::max_element(graph.lengths.begin(), graph.lengths.end());
  double furthest = 0.0;
  for (std::size_t v = 0; v < exact.surface.size(); ++v) {
    const double moved = distance(exact.surface.points[v], jittered.surface.points[v]);
    if (exact.surface.points[v][0] >= 0.0F) {
      ASSERT_EQ(moved, 0.0);
    }
    furthest = std::max(furthest, moved);
  }
  EXPECT_GT(furthest, 0.1 * static_cast<double>(longest));
  EXPECT_LT(furthest, 0.3 * static_cast<double>(longest));
}

TEST(MakeModel, DensityRatioMakesOneEndDenser)
{
  ModelParameters parameters = parametersOf(Body::Human, 8000, 0.0);
  parameters.density_ratio = 16.0;
  const Model model = makeModel(parameters);
  EXPECT_TRUE(topologyOf(model.surface.size(), model.surface.triangles).oriented_manifold);
  const SurfaceGraph graph = buildMeshGraph(model.surface.points, model.surface.triangles);
  double low = 0.0;
  double high = 0.0;
  std::size_t low_count = 0;
  std::size_t high_count = 0;
  for (std::size_t v = 0; v < graph.size(); ++v)
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const float height = model.surface.points[v][1];
      if (height < 0.3F) {
        low += static_cast<double>(graph.lengths[e]);
        ++low_count;
      }
      if (height > 1.5F) {
        high += static_cast<double>(graph.lengths[e]);
        ++high_count;
      }
    }
  // Edge lengths grow with the root of the density: by 4 from end to end, a little less between these parts.
  const double ratio = (low / static_cast<double>(low_count)) / (high / static_cast<double>(high_count));
  EXPECT_GT(ratio, 2.3);
  EXPECT_LT(ratio, 4.5);
}

TEST(MakeModel, RejectsWhatIsOutOfRange)
{
  const auto rejected = [](auto change) {
    ModelParameters parameters;
    change(parameters);
    EXPECT_THROW(makeModel(parameters), std::invalid_argument);
  };
  rejected([](ModelParameters& p) { p.vertices = 999; });
  rejected([](ModelParameters& p) { p.vertices = 4000001; });
  rejected([](ModelParameters& p) { p.bend = -0.1; });
  rejected([](ModelParameters& p) { p.bend = 1.6; });
  rejected([](ModelParameters& p) { p.bend = std::numeric_limits<double>::quiet_NaN(); });
  rejected([](ModelParameters& p) { p.retriangulate = 1.1; });
  rejected([](ModelParameters& p) { p.jitter = 0.5; });
  rejected([](ModelParameters& p) { p.density_ratio = 0.5; });
  rejected([](ModelParameters& p) { p.body = static_cast<Body>(99); });
  EXPECT_THROW(bodyFromName("centipede"), std::invalid_argument);
}

} // namespace
