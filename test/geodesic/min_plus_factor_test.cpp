#include "geodesic/min_plus_factor.h"
#include "geodesic/shortest_paths.h"
#include "support/graphs.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr double any_cost = std::numeric_limits<double>::infinity();

/** Fields of every step-th vertex by elimination. */
DistanceFields
eliminatedFields(const SurfaceGraph& graph, const std::vector<Index>& sources)
{
  MinPlusFactor factor(graph, any_cost);
  EXPECT_TRUE(factor.feasible());
  factor.factorize();
  DistanceFields fields;
  fields.columns = graph.size();
  fields.values.resize(sources.size() * graph.size());
  factor.fields(sources, fields.values.data());
  return fields;
}

std::vector<Index>
everyVertex(const SurfaceGraph& graph, Index step)
{
  std::vector<Index> vertices;
  for (Index v = 0; v < static_cast<Index>(graph.size()); v += step) {
    vertices.push_back(v);
  }
  return vertices;
}

void
expectFieldsOfDijkstra(const SurfaceGraph& graph, Index step)
{
  const std::vector<Index> sources = everyVertex(graph, step);
  const DistanceFields fields = eliminatedFields(graph, sources);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::vector<float> expected = distanceField(graph, sources[i]);
    for (std::size_t v = 0; v < graph.size(); ++v) {
      if (expected[v] < unreachable) {
        ASSERT_NEAR(fields.row(i)[v], expected[v], 2e-6F * expected[v]) << "from " << sources[i] << " to " << v;
      }
      else {
        ASSERT_EQ(fields.row(i)[v], unreachable);
      }
    }
    EXPECT_EQ(fields.row(i)[sources[i]], 0.0F);
  }
}

TEST(MinPlusFactor, GivesTheDistancesOfDijkstra)
{
  expectFieldsOfDijkstra(meshGraph(sphereMesh(4)), 29);
  expectFieldsOfDijkstra(meshGraph(gridMesh(37, 23)), 17);
  expectFieldsOfDijkstra(meshGraph(scaled(torusMesh(60, 20, 2.0F, 0.7F), {1.0F, 3.0F, 0.5F})), 41);
  expectFieldsOfDijkstra(meshGraph(gridMesh(900, 1 + 1)), 101);
}

TEST(MinPlusFactor, GivesThemOnAnyGraph)
{
  expectFieldsOfDijkstra(randomGraph(700, 5, evenLength), 31);
  expectFieldsOfDijkstra(
      randomGraph(700, 6, [](std::mt19937& random) { return random() % 3U == 0U ? 0.0F : evenLength(random); }), 31);
  expectFieldsOfDijkstra(buildGraph(300, {{0, 1, 1.0F}, {200, 299, 2.0F}}), 1); // nearly all vertices on their own
  expectFieldsOfDijkstra(buildGraph(1, {}), 1);
  expectFieldsOfDijkstra(buildGraph(2, {{0, 1, 3.0F}}), 1);
  std::vector<GraphEdge> star;
  for (Index v = 1; v < 400; ++v) {
    star.push_back({0, v, static_cast<float>(v)});
  }
  expectFieldsOfDijkstra(buildGraph(400, star), 7);
}

TEST(MinPlusFactor, GivesThemOnComponentsOfDifferentSize)
{
  const SurfaceGraph sphere = meshGraph(sphereMesh(3));
  std::vector<GraphEdge> edges;
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    for (std::uint32_t e = sphere.offsets[v]; e < sphere.offsets[v + 1]; ++e) {
      const auto a = static_cast<Index>(v);
      edges.push_back({2 * a, 2 * sphere.neighbours[e], sphere.lengths[e]}); // even vertices: one sphere
      if (v < 200 && sphere.neighbours[e] < 200) {
        edges.push_back({2 * a + 1, 2 * sphere.neighbours[e] + 1, sphere.lengths[e]});
      }
    }
  }
  expectFieldsOfDijkstra(buildGraph(2 * sphere.size(), edges), 37);
}

TEST(MinPlusFactor, IsTheSameForAnyNumberOfThreads)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(5));       // large enough to be taken apart by several threads
  const std::vector<Index> sources = everyVertex(graph, 61); // more than are swept together
  const DistanceFields fields = eliminatedFields(graph, sources);
  for (const unsigned threads : {0U, 2U, 3U, 7U}) {
    EXPECT_EQ(withThreads(threads, [&] { return eliminatedFields(graph, sources); }).values, fields.values);
  }
}

TEST(MinPlusFactor, AFieldDoesNotDependOnTheOtherSources)
{
  const SurfaceGraph graph = meshGraph(torusMesh(60, 20, 2.0F, 0.7F));
  const std::vector<Index> sources = everyVertex(graph, 13);
  const DistanceFields together = eliminatedFields(graph, sources);
  for (const std::size_t i : {std::size_t{0}, std::size_t{20}, sources.size() - 1}) {
    const DistanceFields alone = eliminatedFields(graph, {sources[i]});
    EXPECT_TRUE(std::equal(alone.values.begin(), alone.values.end(), together.row(i)));
  }
}

TEST(MinPlusFactor, GivesUpWhereSeparatorsAreLarge)
{
  // A random graph has none: every half of it touches nearly all of the other.
  const SurfaceGraph graph = randomGraph(4000, 8, evenLength);
  EXPECT_FALSE(MinPlusFactor(graph, 40.0 * static_cast<double>(graph.neighbours.size())).feasible());
}

TEST(DistanceFieldSolver, GivesTheSameDistancesInPortions)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(4));
  const std::vector<Index> sources = everyVertex(graph, 7);
  DistanceFieldSolver solver(graph);
  std::size_t next = 0;
  for (const std::size_t portion : {3U, 20U, 1U, 60U, 2U, 40U}) { // first searched, then eliminated
    const std::vector<Index> some(sources.begin() + static_cast<std::ptrdiff_t>(next),
                                  sources.begin() + static_cast<std::ptrdiff_t>(next + portion));
    next += portion;
    const DistanceFields fields = solver.fields(some);
    for (std::size_t i = 0; i < portion; ++i) {
      const std::vector<float> expected = distanceField(graph, some[i]);
      for (std::size_t v = 0; v < graph.size(); ++v) {
        ASSERT_NEAR(fields.row(i)[v], expected[v], 2e-6F * expected[v]);
      }
    }
  }
}

TEST(DistanceFields, ManyOnARandomGraphAreSearched)
{
  const SurfaceGraph graph = randomGraph(4000, 8, evenLength);
  const std::vector<Index> sources = everyVertex(graph, 50);
  const DistanceFields fields = withThreads(2, [&] { return distanceFields(graph, sources); });
  for (std::size_t i = 0; i < sources.size(); i += 9) {
    const std::vector<float> expected = distanceField(graph, sources[i]);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), fields.row(i)));
  }
}

TEST(ShortestPath, IsFoundFromAnEliminatedField)
{
  const SurfaceGraph graph = meshGraph(scaled(sphereMesh(4), {1.0F, 0.6F, 1.7F}));
  const std::vector<Index> sources = everyVertex(graph, 100);
  const DistanceFields fields = eliminatedFields(graph, sources);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (Index target = 3; target < static_cast<Index>(graph.size()); target += 211) {
      const std::vector<Index> path = shortestPath(graph, fields.row(i), target);
      ASSERT_FALSE(path.empty());
      EXPECT_EQ(path.front(), sources[i]);
      EXPECT_EQ(path.back(), target);
      float length = 0.0F;
      for (std::size_t k = 1; k < path.size(); ++k) {
        length += edgeLength(graph, path[k - 1], path[k]);
      }
      EXPECT_NEAR(length, fields.row(i)[target], 1e-5F);
    }
  }
}

} // namespace
