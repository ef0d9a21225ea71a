#include "base/large_memory.h"
#include "geodesic/min_plus_factor.h"
#include "geodesic/nested_dissection.h"
#include "geodesic/shortest_paths.h"
#include "support/graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr double any_cost = std::numeric_limits<double>::infinity();

/** Fields of every step-th vertex by elimination. */
DistanceFields
eliminatedFields(const SurfaceGraph& graph, const std::vector<Index>& sources, unsigned threads)
{
  MinPlusFactor factor(graph, any_cost, threads);
  EXPECT_TRUE(factor.feasible());
  factor.factorize(threads);
  DistanceFields fields;
  fields.columns = graph.size();
  fields.values.resize(sources.size() * graph.size());
  factor.fields(sources, fields.values.data(), threads);
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
  const DistanceFields fields = eliminatedFields(graph, sources, 1);
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

TEST(Dissection, HasEveryVertexOnceAndNoEdgeAcross)
{
  for (const SurfaceGraph& graph : {meshGraph(sphereMesh(4)), meshGraph(gridMesh(70, 3)), meshGraph(gridMesh(1, 1)),
                                    randomGraph(500, 3, evenLength), buildGraph(100, {}), buildGraph(0, {})}) {
    const Dissection dissection = dissect(graph, 10, 1);
    std::vector<Index> sorted = dissection.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Index> all(graph.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);

    std::vector<std::int32_t> node_of(graph.size());
    std::uint32_t next = 0;
    for (std::size_t node = 0; node < dissection.nodes.size(); ++node) {
      const Dissection::Node& owner = dissection.nodes[node];
      EXPECT_EQ(owner.begin, next);
      next = owner.end;
      EXPECT_TRUE(owner.children[0] >= 0 || owner.end - owner.begin <= 10U);
      for (std::uint32_t p = owner.begin; p < owner.end; ++p) {
        node_of[dissection.order[p]] = static_cast<std::int32_t>(node);
      }
    }
    const auto is_ancestor = [&](std::int32_t above, std::int32_t node) {
      while (node >= 0 && node != above) {
        node = dissection.nodes[node].parent;
      }
      return node == above;
    };
    for (std::size_t v = 0; v < graph.size(); ++v) {
      for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
        const std::int32_t other = node_of[graph.neighbours[e]];
        EXPECT_TRUE(is_ancestor(other, node_of[v]) || is_ancestor(node_of[v], other));
      }
    }
  }
}

TEST(Dissection, OfASurfaceHasSmallSeparators)
{
  const SurfaceGraph graph = meshGraph(gridMesh(100, 100));
  const Dissection dissection = dissect(graph, 32, 1);
  const Dissection::Node& root = dissection.nodes.back();
  EXPECT_LE(root.end - root.begin, 150U);
  EXPECT_GE(root.end - root.begin, 50U);
}

TEST(Dissection, CutsWhereTheSurfaceIsNarrow)
{
  // Two squares of different size, joined by a strip of four vertices: the middle lies in the larger one.
  std::vector<GraphEdge> edges;
  const auto add_grid = [&edges](Index first, Index width, Index height) {
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        const Index v = first + y * width + x;
        if (x + 1 < width) {
          edges.push_back({v, v + 1, 1.0F});
        }
        if (y + 1 < height) {
          edges.push_back({v, v + width, 1.0F});
        }
      }
    }
  };
  add_grid(0, 40, 40);
  add_grid(1600, 34, 34);
  for (Index y = 0; y < 4; ++y) {
    edges.push_back({y * 40, 1600 + y * 34, 1.0F});
  }
  const Dissection dissection = dissect(buildGraph(1600 + 34 * 34, edges), 32, 1);
  const Dissection::Node& root = dissection.nodes.back();
  EXPECT_LE(root.end - root.begin, 4U);
}

TEST(Dissection, IsTheSameForAnyNumberOfThreads)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(5));
  const std::vector<Index> order = dissect(graph, 32, 1).order;
  for (const unsigned threads : {2U, 3U, 8U}) {
    EXPECT_EQ(dissect(graph, 32, threads).order, order);
  }
}

TEST(FloatBlock, BeginsWithACacheLineAndGrows)
{
  FloatBlock block;
  for (const std::size_t count : {0U, 1U, 100U, 2000000U, 50U}) {
    float* floats = block.reserve(count);
    ASSERT_NE(floats, nullptr);
    EXPECT_EQ(floats, block.data());
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(floats) % 64, 0U);
    std::fill_n(floats, count, 1.0F);
  }
  const FloatBlock taken = std::move(block);
  block = FloatBlock();
  std::fill_n(block.reserve(1000), 1000, 2.0F);
  EXPECT_EQ(taken.data()[49], 1.0F);
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
  const DistanceFields fields = eliminatedFields(graph, sources, 1);
  for (const unsigned threads : {0U, 2U, 3U, 7U}) {
    EXPECT_EQ(eliminatedFields(graph, sources, threads).values, fields.values);
  }
}

TEST(MinPlusFactor, AFieldDoesNotDependOnTheOtherSources)
{
  const SurfaceGraph graph = meshGraph(torusMesh(60, 20, 2.0F, 0.7F));
  const std::vector<Index> sources = everyVertex(graph, 13);
  const DistanceFields together = eliminatedFields(graph, sources, 1);
  for (const std::size_t i : {std::size_t{0}, std::size_t{20}, sources.size() - 1}) {
    const DistanceFields alone = eliminatedFields(graph, {sources[i]}, 1);
    EXPECT_TRUE(std::equal(alone.values.begin(), alone.values.end(), together.row(i)));
  }
}

TEST(MinPlusFactor, GivesUpWhereSeparatorsAreLarge)
{
  // A random graph has none: every half of it touches nearly all of the other.
  const SurfaceGraph graph = randomGraph(4000, 8, evenLength);
  EXPECT_FALSE(MinPlusFactor(graph, 40.0 * static_cast<double>(graph.neighbours.size()), 1).feasible());
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
    const DistanceFields fields = solver.fields(some, 2);
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
  const DistanceFields fields = distanceFields(graph, sources, 2);
  for (std::size_t i = 0; i < sources.size(); i += 9) {
    const std::vector<float> expected = distanceField(graph, sources[i]);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), fields.row(i)));
  }
}

TEST(ShortestPath, IsFoundFromAnEliminatedField)
{
  const SurfaceGraph graph = meshGraph(scaled(sphereMesh(4), {1.0F, 0.6F, 1.7F}));
  const std::vector<Index> sources = everyVertex(graph, 100);
  const DistanceFields fields = eliminatedFields(graph, sources, 1);
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
