#include "cloud/cloud_surface.h"
#include "cloud/sheets.h"
#include "geodesic/shortest_paths.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(CloudSurface, SharpEdgesStayConnected)
{
  const std::vector<Vector3> points = cubeCloud(24, 4);
  const CloudSurface surface = surfaceOf(points);
  EXPECT_EQ(connectedComponents(surface.graph).sizes.size(), 1U);
  EXPECT_EQ(surface.bridges, 0U);
  // From the top over the edge at x = 0.5 to the side, in the middle part, where no other way is shorter.
  std::size_t pairs = 0;
  float worst = 0.0F;
  for (const float height : {0.45F, 0.3F, 0.02F}) {
    const Index from = nearestTo(points, {0.5F, 0.0F, height});
    const std::vector<float> field = distanceField(surface.graph, from);
    for (std::size_t v = 0; v < points.size(); ++v) {
      const Vector3& p = points[v];
      if (p[2] == 0.5F && p[0] > 0.0F && std::abs(p[1]) < 0.25F) {
        const float unfolded = (0.5F - p[0]) + (0.5F - points[from][2]);
        const float exact = std::hypot(unfolded, p[1] - points[from][1]);
        ASSERT_GT(field[v], exact > 0.25F ? 0.85F * exact : 0.7F * exact); // a chord cuts the corner
        worst = std::max(worst, exact > 0.1F ? field[v] / exact : 0.0F);
        ++pairs;
      }
    }
  }
  EXPECT_GT(pairs, 300U);
  EXPECT_LT(worst, 1.3F);
}

TEST(CloudSurface, LargerDetourTrustsMoreEdges)
{
  const std::vector<Vector3> points = cubeCloud(20, 5);
  const CloudSurface strict = surfaceOf(points, {0.9F, 1.0F});
  const CloudSurface tolerant = surfaceOf(points, {0.9F, 4.0F});
  EXPECT_GT(strict.distrusted_edges, tolerant.distrusted_edges);
  EXPECT_LT(strict.graph.neighbours.size(), tolerant.graph.neighbours.size());
}

TEST(CloudSurface, DetourIsTheLongestWayRoundAnEdgeThatIsKept)
{
  constexpr float bend = 0.8F;
  const std::vector<Vector3> points = cubeCloud(16, 5);
  const SurfaceGraph plain = plainGraph(points);
  const CloudSurface none_kept = surfaceOf(points, {bend, 0.0F});
  ASSERT_EQ(none_kept.bridges, 0U);
  std::vector<std::vector<float>> ways;
  for (std::size_t v = 0; v < points.size(); ++v) {
    ways.push_back(distanceField(none_kept.graph, static_cast<Index>(v)));
  }
  for (const float detour : {1.5F, 2.0F, 3.0F}) {
    SCOPED_TRACE(detour);
    const SurfaceGraph graph = surfaceOf(points, {bend, detour}).graph;
    std::size_t nearly_too_long = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      const auto begin = graph.neighbours.begin() + graph.offsets[v];
      const auto end = graph.neighbours.begin() + graph.offsets[v + 1];
      for (std::uint32_t e = plain.offsets[v]; e < plain.offsets[v + 1]; ++e) {
        const float share = ways[v][plain.neighbours[e]] / (detour * plain.lengths[e]);
        if (std::abs(share - 1.0F) > 1e-3F) {
          ASSERT_EQ(std::find(begin, end, plain.neighbours[e]) != end, share < 1.0F) << share;
        }
        nearly_too_long += share > 0.8F && share < 1.0F ? 1U : 0U;
      }
    }
    EXPECT_GT(nearly_too_long, 20U);
  }
}

TEST(CloudSurface, NormalsOfASpherePointOutwards)
{
  const std::vector<Vector3> points = sphereCloud(1500, 0.4F);
  const CloudSurface surface = surfaceOf(points);
  ASSERT_EQ(surface.normals.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    ASSERT_GT(dot(surface.normals[v], normalized(points[v])), 0.99F);
    ASSERT_NEAR(norm(surface.normals[v]), 1.0F, 1e-4F);
  }
  EXPECT_EQ(surface.distrusted_edges, 0U);
  EXPECT_EQ(surface.graph.neighbours, plainGraph(points).neighbours);
}

TEST(CloudSurface, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<Vector3> points = cubeCloud(24, 6);
  const CloudSurface one = surfaceOf(points);
  const CloudSurface three = withThreads(3, [&] { return surfaceOf(points); });
  EXPECT_EQ(one.graph.neighbours, three.graph.neighbours);
  EXPECT_EQ(one.graph.lengths, three.graph.lengths);
  EXPECT_EQ(one.normals, three.normals);
  EXPECT_EQ(one.triangles, three.triangles);
}

TEST(CloudSurface, RadiusKeepsDistantPartsApart)
{
  std::vector<Vector3> points = sheet(20, 0.0F, 7);
  points.push_back({1.5F, 0.5F, 0.0F});
  const NeighbourLists lists = nearestNeighbours(points, 10);
  EXPECT_EQ(connectedComponents(buildCloudSurface(points, lists, {}, 0.0F, {}).graph).sizes.size(), 1U);
  EXPECT_EQ(connectedComponents(buildCloudSurface(points, lists, {}, 0.2F, {}).graph).sizes,
            (std::vector<Index>{400, 1}));
}

TEST(CloudSurface, TurnsNormalsToAgreeWithTheOrientedOnes)
{
  // All inwards, against what the points alone would suggest.
  const std::vector<Vector3> points = sphereCloud(2000, 0.4F);
  std::vector<Vector3> normals;
  std::vector<char> is_oriented;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_known = i == 700;
    normals.push_back((is_known || i % 3 == 0 ? -1.0F : 1.0F) * normalized(points[i]));
    is_oriented.push_back(static_cast<char>(is_known));
  }
  const CloudSurface surface = buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, {}, is_oriented);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LT(dot(surface.normals[i], points[i]), 0.0F) << i;
  }
}

} // namespace
