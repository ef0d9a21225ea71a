#include "geodesic/shortest_paths.h"
#include "support/graphs.h"
#include "support/with_threads.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** All distances by Floyd and Warshall. */
std::vector<double>
allDistances(const SurfaceGraph& graph)
{
  const std::size_t n = graph.size();
  std::vector<double> d(n * n, std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < n; ++v) {
    d[v * n + v] = 0.0;
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      d[v * n + static_cast<std::size_t>(graph.neighbours[e])] = graph.lengths[e];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        d[i * n + j] = std::min(d[i * n + j], d[i * n + k] + d[k * n + j]);
      }
    }
  }
  return d;
}

/** The same field by Boost.Graph. */
std::vector<float>
boostField(const SurfaceGraph& graph, Index source)
{
  using Boost = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, float>>;
  Boost boost_graph(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      boost::add_edge(v, static_cast<std::size_t>(graph.neighbours[e]), graph.lengths[e], boost_graph);
    }
  }
  std::vector<float> field(graph.size());
  boost::dijkstra_shortest_paths(boost_graph, static_cast<std::size_t>(source),
                                 boost::distance_map(field.data()).distance_inf(unreachable));
  return field;
}

float
pathLength(const SurfaceGraph& graph, const std::vector<Index>& path)
{
  float sum = 0.0F;
  for (std::size_t i = 1; i < path.size(); ++i) {
    sum += edgeLength(graph, path[i - 1], path[i]);
  }
  return sum;
}

} // namespace

TEST(DistanceField, AgreesWithFloydAndWarshall)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    const SurfaceGraph graph = randomGraph(60, seed, evenLength);
    const std::vector<double> expected = allDistances(graph);
    for (Index source = 0; source < 60; ++source) {
      const std::vector<float> field = distanceField(graph, source);
      for (std::size_t v = 0; v < 60; ++v) {
        EXPECT_NEAR(field[v], expected[static_cast<std::size_t>(source) * 60 + v], 1e-5);
      }
    }
  }
}

TEST(DistanceField, IsBoostsDijkstraToTheLastBit)
{
  for (const SurfaceGraph& graph : {meshGraph(sphereMesh(4)), meshGraph(gridMesh(37, 23)),
                                    meshGraph(torusMesh(60, 20, 2.0F, 0.7F)), randomGraph(3000, 5, evenLength)}) {
    for (const Index source : {0, 17, static_cast<Index>(graph.size()) - 1}) {
      EXPECT_EQ(distanceField(graph, source), boostField(graph, source));
    }
  }
}

TEST(DistanceField, CopesWithAHugeSpreadOfLengths)
{
  // Seven orders of magnitude: the buckets cannot be as narrow as the shortest edges ask for.
  const auto spread = [](std::mt19937& random) {
    return std::pow(10.0F, static_cast<float>(random() % 8U) - 4.0F);
  };
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const SurfaceGraph graph = randomGraph(2000, seed, spread);
    EXPECT_EQ(distanceField(graph, 7), boostField(graph, 7));
  }
  std::vector<GraphEdge> chain;
  for (Index v = 0; v < 20000; ++v) {
    chain.push_back({v, v + 1, v == 10000 ? 1e6F : 1e-3F});
  }
  const SurfaceGraph graph = buildGraph(20001, chain);
  EXPECT_EQ(distanceField(graph, 0), boostField(graph, 0));
}

TEST(DistanceField, CopesWithEdgesOfLengthZero)
{
  const auto often_zero = [](std::mt19937& random) {
    return random() % 3U == 0U ? 0.0F : evenLength(random);
  };
  const SurfaceGraph graph = randomGraph(2000, 9, often_zero);
  EXPECT_EQ(distanceField(graph, 3), boostField(graph, 3));
  const SurfaceGraph all_zero = randomGraph(50, 9, [](std::mt19937&) { return 0.0F; });
  EXPECT_EQ(distanceField(all_zero, 3), std::vector<float>(50, 0.0F));
  EXPECT_EQ(shortestPath(all_zero, 3, 3), std::vector<Index>{3});
  EXPECT_EQ(shortestPath(all_zero, 0, 40).back(), 40);
}

TEST(DistanceField, IsInfiniteWhereThereIsNoWay)
{
  const SurfaceGraph graph = buildGraph(5, {{0, 1, 1.0F}, {3, 4, 2.0F}});
  EXPECT_EQ(distanceField(graph, 0), (std::vector<float>{0.0F, 1.0F, unreachable, unreachable, unreachable}));
  EXPECT_EQ(distanceField(graph, 2), (std::vector<float>{unreachable, unreachable, 0.0F, unreachable, unreachable}));
  EXPECT_TRUE(shortestPath(graph, 0, 4).empty());
}

TEST(DistanceField, OnATreeIsTheSumAlongTheBranches)
{
  std::vector<GraphEdge> edges; // a binary tree; the edge above v has length v
  for (Index v = 1; v < 1023; ++v) {
    edges.push_back({v, (v - 1) / 2, static_cast<float>(v)});
  }
  const std::vector<float> field = distanceField(buildGraph(1023, edges), 0);
  for (Index v = 0; v < 1023; ++v) {
    float sum = 0.0F;
    for (Index u = v; u > 0; u = (u - 1) / 2) {
      sum += static_cast<float>(u);
    }
    EXPECT_EQ(field[v], sum);
  }
}

TEST(DistanceField, OnAGridIsTheOctileDistanceAlongTheDiagonals)
{
  // The diagonals run from lower left to upper right: upwards to the right they are used, otherwise sides are.
  const SurfaceGraph graph = meshGraph(gridMesh(30, 20));
  const std::vector<float> field = distanceField(graph, 5 * 30 + 5);
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 30; ++i) {
      const int dx = i - 5;
      const int dy = j - 5;
      const int diagonal = dx * dy > 0 ? std::min(std::abs(dx), std::abs(dy)) : 0;
      const float expected = static_cast<float>(std::abs(dx) + std::abs(dy) - 2 * diagonal) +
                             std::sqrt(2.0F) * static_cast<float>(diagonal);
      EXPECT_NEAR(field[j * 30 + i], expected, 1e-4F * (1.0F + expected));
    }
  }
}

TEST(DistanceField, OnASphereIsTheArcButForTheZigzagOfEdges)
{
  const Surface sphere = sphereMesh(5);
  const std::vector<float> field = distanceField(meshGraph(sphere), 4); // from the pole (0, 0, 1)
  double ratio = 0.0;
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    const float arc = std::acos(std::min(1.0F, std::max(-1.0F, sphere.points[v][2])));
    EXPECT_GE(field[v], 0.998F * arc); // chords are a little shorter than arcs
    EXPECT_LE(field[v], 1.42F * arc);  // sqrt (2): the worst direction between edges that meet at a right angle
    ratio += arc > 0.0F ? field[v] / arc : 1.0F;
  }
  EXPECT_LT(ratio / static_cast<double>(sphere.size()), 1.1);
}

TEST(DistanceField, FromSeveralSourcesIsTheLeastOfTheirFields)
{
  const SurfaceGraph graph = meshGraph(torusMesh(40, 16, 2.0F, 0.7F));
  const std::vector<Index> sources = {3, 200, 555};
  const std::vector<float> joint = distanceField(graph, sources);
  const DistanceFields single = distanceFields(graph, sources);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    EXPECT_EQ(joint[v], std::min({single.row(0)[v], single.row(1)[v], single.row(2)[v]}));
  }
}

TEST(DistanceFields, AreTheFieldsOfTheirSources)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(4));
  for (const std::size_t count : {1U, 20U, 50U, 200U}) { // few are searched, many eliminated
    std::vector<Index> sources(count);
    std::iota(sources.begin(), sources.end(), 100);
    const DistanceFields fields = distanceFields(graph, sources);
    ASSERT_EQ(fields.rows(), count);
    ASSERT_EQ(fields.columns, graph.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const std::vector<float> field = distanceField(graph, sources[i]);
      for (std::size_t v = 0; v < graph.size(); ++v) {
        ASSERT_NEAR(fields.row(i)[v], field[v], 2e-6F * field[v]);
      }
    }
  }
}

TEST(DistanceFields, AreTheSameForAnyNumberOfThreads)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(4));
  for (const std::size_t count : {20U, 200U}) {
    std::vector<Index> sources(count);
    std::iota(sources.begin(), sources.end(), 100);
    const DistanceFields fields = distanceFields(graph, sources);
    for (const unsigned threads : {0U, 2U, 7U}) {
      EXPECT_EQ(withThreads(threads, [&] { return distanceFields(graph, sources); }).values, fields.values);
    }
  }
  EXPECT_EQ(withThreads(2, [&] { return distanceFields(graph, {}); }).rows(), 0U);
}

TEST(DistanceFields, AreSymmetric)
{
  const SurfaceGraph graph = meshGraph(scaled(sphereMesh(4), {1.0F, 0.6F, 1.7F}));
  std::vector<Index> sources;
  for (Index v = 0; v < static_cast<Index>(graph.size()); v += 37) {
    sources.push_back(v);
  }
  const DistanceFields fields = withThreads(2, [&] { return distanceFields(graph, sources); });
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t j = 0; j < sources.size(); ++j) {
      // Not equal bits: the sum of a path depends on the end it starts from.
      EXPECT_NEAR(fields.row(i)[sources[j]], fields.row(j)[sources[i]], 1e-5F);
    }
  }
}

TEST(ShortestPath, RunsAlongEdgesAndIsAsLongAsTheDistance)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(4));
  const std::vector<float> field = distanceField(graph, 11);
  for (Index target = 0; target < static_cast<Index>(graph.size()); target += 101) {
    const std::vector<Index> path = shortestPath(graph, 11, target);
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.front(), 11);
    EXPECT_EQ(path.back(), target);
    EXPECT_NEAR(pathLength(graph, path), field[target], 1e-5F);
    const std::vector<Index> from_field = shortestPath(graph, field.data(), target);
    EXPECT_EQ(from_field.front(), 11);
    EXPECT_EQ(from_field.back(), target);
    EXPECT_NEAR(pathLength(graph, from_field), field[target], 1e-5F);
  }
}

TEST(ShortestPath, FindsItsWayFromAFieldOverEdgesOfLengthZero)
{
  const SurfaceGraph graph = buildGraph(5, {{0, 1, 0.0F}, {1, 2, 1.0F}, {2, 3, 0.0F}, {3, 4, 1.0F}});
  EXPECT_EQ(shortestPath(graph, distanceField(graph, 0).data(), 3).back(), 3);
  EXPECT_EQ(shortestPath(graph, distanceField(graph, 0).data(), 3).front(), 0);
  EXPECT_EQ(pathLength(graph, shortestPath(graph, distanceField(graph, 0).data(), 4)), 2.0F);
  const SurfaceGraph apart = buildGraph(2, {});
  EXPECT_TRUE(shortestPath(apart, distanceField(apart, 0).data(), 1).empty());
}

TEST(PathMidpoint, IsTheVertexClosestToHalfTheLength)
{
  const SurfaceGraph chain = buildGraph(5, {{0, 1, 1.0F}, {1, 2, 1.0F}, {2, 3, 1.0F}, {3, 4, 5.0F}});
  EXPECT_EQ(pathMidpoint(chain, {0, 1, 2, 3, 4}), 3); // at 3 of 8: nearer to 4 than 8 is
  EXPECT_EQ(pathMidpoint(chain, {0, 1, 2}), 1);
  EXPECT_EQ(pathMidpoint(chain, {2}), 2);
  EXPECT_EQ(pathMidpoint(chain, {}), no_index);
}
