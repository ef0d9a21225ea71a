#include "benchmark/graph_accuracy.h"
#include "geodesic/shortest_paths.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

constexpr float scale = 0.25F;

/** A surface of the points of a mesh, scaled, with a graph of the mesh's edges and perhaps a shortcut. */
PreparedSurface
prepared(const Surface& mesh, const std::vector<GraphEdge>& shortcuts = {})
{
  PreparedSurface surface;
  surface.scale = scale;
  for (const Vector3& p : mesh.points)
    surface.points.push_back({scale * p[0], scale * p[1], scale * p[2]});
  surface.original.resize(mesh.size());
  std::iota(surface.original.begin(), surface.original.end(), 0);
  surface.representatives = surface.original;
  const SurfaceGraph whole = buildMeshGraph(surface.points, mesh.triangles);
  std::vector<GraphEdge> edges = shortcuts;
  for (std::size_t v = 0; v < whole.size(); ++v)
    for (std::uint32_t e = whole.offsets[v]; e < whole.offsets[v + 1]; ++e)
      if (whole.neighbours[e] > static_cast<Index>(v))
        edges.push_back({static_cast<Index>(v), whole.neighbours[e], whole.lengths[e]});
  surface.graph = buildGraph(mesh.size(), edges);
  return surface;
}

std::vector<Index>
allPoints(const Surface& mesh)
{
  std::vector<Index> all(mesh.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(CompareGraph, TheSameGraphHasNoError)
{
  const Surface strip = test::gridMesh(60, 4);
  const GraphAccuracy same = compareGraph(strip, prepared(strip), allPoints(strip));
  EXPECT_GT(same.pairs, 10000U);
  EXPECT_NEAR(same.median_error, 0.0, 1e-6);
  EXPECT_EQ(same.short_pairs, 0.0);
}

TEST(CompareGraph, AShortcutShortensThePairsAtItsEnds)
{
  const Surface strip = test::gridMesh(60, 1 + 1); // 120 points: all are sources or nearly so, and targets
  const PreparedSurface ring = prepared(strip, {{0, 59, 0.0F}});
  const GraphAccuracy accuracy = compareGraph(strip, ring, allPoints(strip));

  // By brute force: every second point is a source.
  const SurfaceGraph mesh = buildMeshGraph(strip.points, strip.triangles);
  std::size_t pairs = 0;
  std::size_t shortened = 0;
  for (Index source = 0; source < 120; source += 2) {
    const std::vector<float> truth = distanceField(mesh, source);
    const std::vector<float> field = distanceField(ring.graph, source);
    for (Index target = 0; target < 120; ++target)
      if (truth[target] >= 0.05F * 59.4142F) {
        ++pairs;
        shortened += field[target] / scale < 0.8F * truth[target] ? 1U : 0U;
      }
  }
  EXPECT_EQ(accuracy.pairs, pairs);
  EXPECT_GT(shortened, 500U);
  EXPECT_DOUBLE_EQ(accuracy.short_pairs, static_cast<double>(shortened) / static_cast<double>(pairs));
}

TEST(CompareGraph, LeavesOutWhatHasNoPointOnBothSides)
{
  const Surface strip = test::gridMesh(60, 4);
  PreparedSurface surface = prepared(strip);
  std::vector<Index> origins = allPoints(strip);
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (i % 3 == 0)
      origins[i] = no_index; // an outlier of the input
    if (i % 3 == 1)
      surface.representatives[i] = no_index; // left out by the estimation
  }
  const GraphAccuracy some = compareGraph(strip, surface, origins);
  EXPECT_GT(some.pairs, 1000U);
  EXPECT_LT(some.pairs, 80U * 80U);
  const GraphAccuracy none = compareGraph(strip, surface, std::vector<Index>(strip.size(), no_index));
  EXPECT_EQ(none.pairs, 0U);
  EXPECT_EQ(none.short_pairs, 0.0);
}

TEST(PrintGraphs, HasMeansOfClassesAndOfSets)
{
  std::vector<GraphRun> runs(4);
  const auto set = [&runs](std::size_t i, const char* class_name, double error, double shortened) {
    runs[i].model.set = "SET";
    runs[i].model.class_name = class_name;
    runs[i].model.name = std::string(class_name) + std::to_string(i);
    runs[i].accuracy = {100, error, shortened};
  };
  set(0, "cat", 0.01, 0.02);
  set(1, "cat", 0.03, 0.04);
  set(2, "dog", 0.04, 0.05);
  set(3, "dog", 0.9, 0.9);
  runs[3].failure = "cannot be read";
  std::ostringstream out;
  printGraphs(out, runs);
  const auto has = [&out](const std::string& name, const std::string& figures) {
    const std::size_t begin = out.str().find(name);
    return begin != std::string::npos && out.str().find(figures, begin) < out.str().find('\n', begin);
  };
  EXPECT_TRUE(has("SET/cat0", "1.00      2.00")) << out.str();
  EXPECT_TRUE(has("SET/cat  ", "2.00      3.00")) << out.str();
  EXPECT_TRUE(has("SET/dog  ", "4.00      5.00")) << "without the failed one\n" << out.str();
  EXPECT_TRUE(has("SET (mean of classes)", "3.00      4.00")) << out.str();
  EXPECT_TRUE(has("SET/dog3", "failed: cannot be read")) << out.str();
}

} // namespace
} // namespace symmetry
} // namespace pcl
