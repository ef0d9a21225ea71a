#include "geodesic/farthest_point_sampling.h"
#include "geodesic/shortest_paths.h"
#include "support/graphs.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** By definition: each sample is the lowest of the vertices farthest from all samples before it. */
FarthestPointSamples
plainSampling(const SurfaceGraph& graph, Index start, std::size_t count)
{
  FarthestPointSamples samples;
  samples.distance.assign(graph.size(), unreachable);
  samples.owner.assign(graph.size(), no_index);
  Index next = start;
  while (samples.vertices.size() < count && samples.distance[next] > 0.0F) {
    samples.radii.push_back(samples.distance[next]);
    const std::vector<float> field = distanceField(graph, next);
    for (std::size_t v = 0; v < graph.size(); ++v) {
      if (field[v] < samples.distance[v]) {
        samples.distance[v] = field[v];
        samples.owner[v] = static_cast<Index>(samples.vertices.size());
      }
    }
    samples.vertices.push_back(next);
    next = 0;
    for (std::size_t v = 1; v < graph.size(); ++v) {
      const bool reached = samples.distance[v] < unreachable;
      if (reached && !(samples.distance[next] < unreachable && samples.distance[next] >= samples.distance[v])) {
        next = static_cast<Index>(v);
      }
    }
  }
  return samples;
}

void
expectAsDefined(const SurfaceGraph& graph, Index start, std::size_t count)
{
  const FarthestPointSamples samples = farthestPointSampling(graph, start, count);
  const FarthestPointSamples expected = plainSampling(graph, start, count);
  EXPECT_EQ(samples.vertices, expected.vertices);
  EXPECT_EQ(samples.radii, expected.radii);
  EXPECT_EQ(samples.distance, expected.distance);
  EXPECT_EQ(samples.owner, expected.owner);
}

} // namespace

TEST(FarthestPointSampling, IsAsDefined)
{
  expectAsDefined(meshGraph(sphereMesh(4)), 0, 150);
  expectAsDefined(meshGraph(torusMesh(50, 18, 2.0F, 0.7F)), 123, 100);
  expectAsDefined(randomGraph(1500, 3, evenLength), 8, 200);
}

TEST(FarthestPointSampling, GivesTiesToTheLowestVertex)
{
  expectAsDefined(meshGraph(gridMesh(33, 33)), 16 * 33 + 16, 60); // four corners, then many equal distances
}

TEST(FarthestPointSampling, EndsWhenEveryVertexIsASample)
{
  const FarthestPointSamples samples = farthestPointSampling(meshGraph(gridMesh(4, 4)), 5, 100);
  EXPECT_EQ(samples.vertices.size(), 16U);
  EXPECT_EQ(samples.distance, std::vector<float>(16, 0.0F));
}

TEST(FarthestPointSampling, TakesOneOfVerticesAtDistanceZero)
{
  const SurfaceGraph graph = buildGraph(4, {{0, 1, 0.0F}, {1, 2, 1.0F}, {2, 3, 0.0F}});
  EXPECT_EQ(farthestPointSampling(graph, 0, 4).vertices, (std::vector<Index>{0, 2}));
}

TEST(FarthestPointSampling, StaysInTheComponentOfItsStart)
{
  const SurfaceGraph graph = buildGraph(5, {{0, 1, 1.0F}, {1, 2, 1.0F}, {3, 4, 9.0F}});
  const FarthestPointSamples samples = farthestPointSampling(graph, 1, 5);
  EXPECT_EQ(samples.vertices, (std::vector<Index>{1, 0, 2}));
  EXPECT_EQ(samples.owner, (std::vector<Index>{1, 0, 2, no_index, no_index}));
  EXPECT_EQ(samples.distance[3], unreachable);
}

TEST(FarthestPointSampling, AShorterSequenceIsThePrefixOfALongerOne)
{
  const SurfaceGraph graph = meshGraph(sphereMesh(3));
  const std::vector<Index> many = farthestPointSampling(graph, 2, 80).vertices;
  const std::vector<Index> few = farthestPointSampling(graph, 2, 30).vertices;
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}
