#include "geodesic/bucket_queue.h"
#include "support/graphs.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** Bellman and Ford: every edge over and over, until none lowers a distance. */
std::vector<float>
lowered(const SurfaceGraph& graph, std::vector<float> distances)
{
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t v = 0; v < graph.size(); ++v) {
      for (const auto [w, length] : graph.edges(v)) {
        if (distances[v] + length < distances[w]) {
          distances[w] = distances[v] + length;
          changed = true;
        }
      }
    }
  }
  return distances;
}

std::vector<float>
startingAt(std::size_t n, const std::vector<Index>& sources)
{
  std::vector<float> distances(n, infinity);
  for (const Index source : sources) {
    distances[source] = 0.0F;
  }
  return distances;
}

void
expectLowered(const SurfaceGraph& graph, BucketQueue& queue, const std::vector<Index>& sources, std::vector<float> from)
{
  const std::vector<float> expected = lowered(graph, from);
  std::vector<Index> parent(graph.size(), no_index);
  queue.relax(sources, from.data(), [&parent](Index v, Index by_way_of) { parent[v] = by_way_of; });
  EXPECT_EQ(from, expected); // to the last bit
  for (std::size_t v = 0; v < graph.size(); ++v) {
    if (parent[v] != no_index) {
      EXPECT_EQ(from[parent[v]] + edgeLength(graph, parent[v], static_cast<Index>(v)), from[v]);
    }
  }
}

TEST(BucketQueue, FindsTheLeastOfAllPathSums)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    const SurfaceGraph graph = randomGraph(400, seed, evenLength);
    BucketQueue queue(graph); // one for all searches
    for (const std::vector<Index>& sources : {std::vector<Index>{0}, {399}, {7, 200, 311}}) {
      expectLowered(graph, queue, sources, startingAt(graph.size(), sources));
    }
  }
}

/** A long narrow band of short edges beside a few that are a million times as long: all of it lies in one bucket, where what
 * comes first is seldom nearest. */
TEST(BucketQueue, ExpandsACrowdedBucketNearestFirst)
{
  constexpr Index rows = 8;
  constexpr Index columns = 4000;
  std::mt19937 random(9);
  std::vector<GraphEdge> edges;
  const auto join = [&](Index a, Index b) {
    edges.push_back({a, b, 1e-6F * evenLength(random)});
  };
  for (Index v = 0; v < rows * columns; ++v) {
    if (v % rows + 1 < rows)
      join(v, v + 1);
    if (v + rows < rows * columns)
      join(v, v + rows);
  }
  for (Index v = rows * columns; v < rows * columns + 400; ++v)
    edges.push_back({v - 1, v, 100.0F});
  const SurfaceGraph graph = buildGraph(rows * columns + 400, edges);
  BucketQueue queue(graph);
  std::vector<float> distances = startingAt(graph.size(), {0});
  std::size_t improvements = 0;
  queue.relax({0}, distances.data(), [&improvements](Index, Index) { ++improvements; });
  EXPECT_EQ(distances, lowered(graph, startingAt(graph.size(), {0})));
  EXPECT_LT(improvements, 2 * graph.size());
}

TEST(BucketQueue, TakesEdgesOfLengthZeroAndVeryLongOnes)
{
  const SurfaceGraph graph = randomGraph(300, 4, [](std::mt19937& random) {
    const float length = evenLength(random);
    return random() % 4U == 0 ? 0.0F : random() % 50U == 0 ? 1e6F * length : length;
  });
  BucketQueue queue(graph);
  expectLowered(graph, queue, {5}, startingAt(graph.size(), {5}));

  const SurfaceGraph flat = randomGraph(50, 5, [](std::mt19937&) { return 0.0F; });
  BucketQueue flat_queue(flat);
  expectLowered(flat, flat_queue, {5}, startingAt(flat.size(), {5}));
}

TEST(BucketQueue, LowersOnlyWhatItImproves)
{
  const SurfaceGraph graph = meshGraph(gridMesh(20, 20));
  BucketQueue queue(graph);
  std::vector<float> distances = lowered(graph, startingAt(graph.size(), {0}));
  distances[399] = 0.25F; // a second source, with a distance of its own
  expectLowered(graph, queue, {399}, distances);
}

TEST(BucketQueue, LeavesWhatIsOutOfReachAlone)
{
  const SurfaceGraph graph = buildGraph(4, {{0, 1, 1.0F}, {2, 3, 1.0F}});
  BucketQueue queue(graph);
  std::vector<float> distances = startingAt(4, {0});
  queue.relax({0}, distances.data(), [](Index, Index) {});
  EXPECT_EQ(distances, (std::vector<float>{0.0F, 1.0F, infinity, infinity}));
}

} // namespace
