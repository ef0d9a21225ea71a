// Parts of a body in contact: which edges of a cloud_surface.h lead from one to the other.
#include "cloud/cloud_surface.h"
#include "cloud/sheets.h"
#include "geodesic/shortest_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float pi = 3.14159265F;

/** Edges between the points before a number and the others. */
std::size_t
edgesAcross(const SurfaceGraph& graph, std::size_t first_of_other)
{
  std::size_t across = 0;
  for (std::size_t v = 0; v < first_of_other; ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      across += static_cast<std::size_t>(graph.neighbours[e]) >= first_of_other ? 1U : 0U;
    }
  }
  return across;
}

/** A tube of radius 0.1 bent to a ring of radius 0.35 until the round ends almost touch: opposite sides of a body in
 * contact. */
struct BentTube {
  std::vector<float> along; ///< place along the tube
  std::vector<Vector3> points;
  std::vector<Vector3> normals; ///< the true ones
  float length = 0.0F;
};

BentTube
bentTube(float spacing, float gap)
{
  constexpr float ring = 0.35F;
  constexpr float radius = 0.1F;
  BentTube tube;
  tube.length = ring * 2.0F * (pi - std::asin((2.0F * radius + gap) / (2.0F * ring)));
  const float quarter = 0.5F * pi * radius; // from the tip to where the tube begins
  const auto rows = static_cast<int>((tube.length + 2.0F * quarter) / spacing);
  for (int row = 0; row <= rows; ++row) {
    const float s = (tube.length + 2.0F * quarter) * static_cast<float>(row) / static_cast<float>(rows) - quarter;
    const float middle = std::min(std::max(s, 0.0F), tube.length);
    const float latitude = (s - middle) / radius;
    const float side = std::cos(latitude);
    const auto columns = std::max(1, static_cast<int>(2.0F * pi * radius * side / spacing));
    for (int column = 0; column < columns; ++column) {
      const float angle =
          2.0F * pi * (static_cast<float>(column) + (row % 2 == 0 ? 0.0F : 0.5F)) / static_cast<float>(columns);
      const float turn = middle / ring;
      const Vector3 outward{std::cos(turn), std::sin(turn), 0.0F};
      const Vector3 tangent{-std::sin(turn), std::cos(turn), 0.0F};
      tube.along.push_back(s);
      tube.normals.push_back((side * std::cos(angle)) * outward + std::sin(latitude) * tangent +
                             Vector3{0.0F, 0.0F, side * std::sin(angle)});
      tube.points.push_back(ring * outward + radius * tube.normals.back());
    }
  }
  return tube;
}

std::size_t
edgesBetweenEnds(const BentTube& tube, const SurfaceGraph& graph)
{
  std::size_t edges = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      edges += tube.along[graph.neighbours[e]] - tube.along[v] > 0.5F * tube.length ? 1U : 0U;
    }
  }
  return edges;
}

void
expectOpenRing(const BentTube& tube, const std::vector<Vector3>& normals)
{
  const SurfaceGraph plain = plainGraph(tube.points);
  ASSERT_GT(edgesBetweenEnds(tube, plain), 5U);
  const NeighbourLists lists = nearestNeighbours(tube.points, 10);
  const CloudSurface surface = buildCloudSurface(tube.points, lists, normals, 0.0F, {});
  EXPECT_EQ(edgesBetweenEnds(tube, surface.graph), 0U);
  EXPECT_EQ(surface.bridges, 0U);
  const auto last = static_cast<Index>(tube.points.size() - 1);
  EXPECT_LT(distanceField(plain, 0)[last], 0.2F * tube.length);
  EXPECT_GT(distanceField(surface.graph, 0)[last], 0.8F * tube.length); // along the inner side
  for (std::size_t v = 0; v < tube.points.size(); ++v) {
    ASSERT_GT(dot(surface.normals[v], tube.normals[v]), 0.7F);
  }
}

TEST(CloudContact, EndsInContactAreNotJoined)
{
  constexpr float spacing = 0.02F;
  for (const float gap : {0.8F, 1.1F}) {
    SCOPED_TRACE(gap);
    expectOpenRing(bentTube(spacing, gap * spacing), {});
  }
}

TEST(CloudContact, EndsInCloserContactAreNotJoinedWhereNormalsAreGiven)
{
  constexpr float spacing = 0.02F;
  for (const float gap : {0.1F, 0.2F, 0.5F, 0.8F, 1.1F}) {
    SCOPED_TRACE(gap);
    const BentTube tube = bentTube(spacing, gap * spacing);
    expectOpenRing(tube, tube.normals);
  }
}

/** Half a spacing apart, the plane of a point's neighbours is a blend of both ends. */
TEST(CloudContact, SheetNormalsKeepEndsInCloserContactApart)
{
  constexpr float spacing = 0.015F;
  for (const float gap : {0.4F, 0.5F, 0.6F}) {
    SCOPED_TRACE(gap);
    const BentTube tube = bentTube(spacing, gap * spacing);
    EXPECT_GT(edgesBetweenEnds(tube, surfaceOf(tube.points, {0.85F, 6.0F, 0.5F}).graph), 10U);
    const CloudSurface surface = surfaceOf(tube.points, {0.85F, 6.0F, 0.5F, true});
    EXPECT_EQ(edgesBetweenEnds(tube, surface.graph), 0U);
    EXPECT_EQ(surface.bridges, 0U);
  }
}

TEST(CloudContact, SheetsFacingEachOtherAreJoinedByOneBridge)
{
  constexpr int n = 30;
  for (const float gap : {0.3F, 0.8F, 1.4F}) {
    std::vector<Vector3> points = sheet(n, 0.0F, 1);
    const std::size_t first_of_other = points.size();
    const std::vector<Vector3> upper = sheet(n, gap / n, 2);
    points.insert(points.end(), upper.begin(), upper.end());
    std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 1.0F});
    std::fill(normals.begin() + n * n, normals.end(), Vector3{0.0F, 0.0F, -1.0F});
    ASSERT_GT(edgesAcross(plainGraph(points), first_of_other), points.size());
    const CloudSurface surface = buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, {});
    EXPECT_EQ(connectedComponents(surface.graph).sizes.size(), 1U);
    EXPECT_EQ(edgesAcross(surface.graph, first_of_other), 1U);
    EXPECT_EQ(surface.bridges, 1U);
    EXPECT_EQ(surface.distrusted_edges, edgesAcross(plainGraph(points), first_of_other) - 1);
    for (const Triangle& t : surface.triangles) {
      const auto above =
          std::count_if(t.begin(), t.end(), [&](Index v) { return static_cast<std::size_t>(v) >= first_of_other; });
      ASSERT_EQ(above % 3, 0); // none across
    }
  }
}

TEST(CloudContact, TouchingSpheresAreJoinedAtTheContact)
{
  constexpr float radius = 0.25F;
  constexpr float gap = 0.004F; // a quarter of the spacing
  std::vector<Vector3> points = sphereCloud(2000, radius, {-radius, 0.0F, 0.0F});
  const std::size_t first_of_other = points.size();
  std::vector<Vector3> normals;
  for (std::size_t v = 0; v < first_of_other; ++v) {
    normals.push_back(normalized(points[v] - Vector3{-radius, 0.0F, 0.0F}));
  }
  for (std::size_t v = 0; v < first_of_other; ++v) { // the mirror image
    points.push_back({gap - points[v][0], points[v][1], points[v][2]});
    normals.push_back({-normals[v][0], normals[v][1], normals[v][2]});
  }
  ASSERT_GT(edgesAcross(plainGraph(points), first_of_other), 50U);
  const CloudSurface surface = buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, {});
  EXPECT_EQ(connectedComponents(surface.graph).sizes.size(), 1U);
  EXPECT_EQ(surface.bridges, 1U);
  EXPECT_EQ(edgesAcross(surface.graph, first_of_other), 1U);

  // From a place aside of the contact to its mirror image: down to the contact and up again.
  constexpr float angle = 1.0F;
  const Index from = nearestTo(points, {-radius + radius * std::cos(angle), radius * std::sin(angle), 0.0F});
  const Index to = from + static_cast<Index>(first_of_other);
  const float length = distanceField(surface.graph, from)[to];
  EXPECT_GT(length, 0.9F * 2.0F * radius * angle);
  EXPECT_LT(length, 1.3F * 2.0F * radius * angle);
}

/** Two sheets that overlap, half a spacing apart, the normals of one turned the wrong way: the normals agree where they
 * should not.
 */
TEST(CloudContact, AStepLeadsToAParallelSheetWhicheverWayItsNormalsAreTurned)
{
  constexpr int n = 30;
  constexpr float gap = 0.5F / n;
  for (const float turned : {1.0F, -1.0F}) {
    std::vector<Vector3> points = sheet(n, 0.0F, 3);
    std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 1.0F});
    const std::size_t first_of_other = points.size();
    for (const Vector3& p : sheet(n, gap, 4)) {
      points.push_back(p + Vector3{0.75F, 0.0F, 0.0F});
      normals.push_back({0.0F, 0.0F, turned});
    }
    const auto across = [&](const ContactTest& contact) {
      return edgesAcross(buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, contact).graph,
                         first_of_other);
    };
    const std::size_t all = edgesAcross(plainGraph(points), first_of_other);
    ASSERT_GT(all, points.size() / 2);
    EXPECT_EQ(across({0.85F, 6.0F, 0.0F, false, 0.15F}), 1U) << "the one that joins them";
    EXPECT_EQ(across({0.85F, 6.0F}) > all / 4, turned > 0.0F);
  }
}

/** Heights in steps of a fifth of the spacing: whatever is rough all over is no contact. */
TEST(CloudContact, RoughnessIsNoStep)
{
  constexpr int n = 30;
  std::mt19937 random(7);
  std::vector<Vector3> points = sheet(n, 0.0F, 3);
  for (Vector3& p : points) {
    p[2] = 0.2F / n * std::round(evenly(random, -1.0F, 1.0F));
  }
  const std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 1.0F});
  const CloudSurface surface =
      buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, {0.85F, 1.0F, 0.0F, false, 0.15F});
  EXPECT_EQ(surface.distrusted_edges, 0U);
}

/** A sheet that is flat but for a quarter of a cylinder, four spacings in radius. */
TEST(CloudContact, ABendIsNoStep)
{
  constexpr int n = 30;
  constexpr float radius = 4.0F / n;
  constexpr float begin = 0.5F;
  std::vector<Vector3> points = sheet(n, 0.0F, 3);
  std::vector<Vector3> normals;
  for (Vector3& p : points) {
    const float angle = std::min(std::max(p[0] - begin, 0.0F) / radius, 0.5F * pi);
    const float beyond = std::max(p[0] - begin - 0.5F * pi * radius, 0.0F);
    normals.push_back({std::sin(angle), 0.0F, std::cos(angle)});
    p = {std::min(p[0], begin) + radius * std::sin(angle), p[1], radius * (std::cos(angle) - 1.0F) - beyond};
  }
  const CloudSurface surface =
      buildCloudSurface(points, nearestNeighbours(points, 10), normals, 0.0F, {0.0F, 1.0F, 0.0F, false, 0.15F});
  EXPECT_EQ(surface.distrusted_edges, 0U);
}

/** Two bodies that touch: their tops side by side in one plane, and the one layer that is left of their walls. */
TEST(CloudContact, DepthFindsTheLayerBetweenMergedBodies)
{
  constexpr int n = 40;
  constexpr float middle = 0.5F;
  std::vector<Vector3> points = sheet(n, 0.0F, 8);
  const auto right =
      std::stable_partition(points.begin(), points.end(), [](const Vector3& p) { return p[0] < middle; });
  const std::vector<Vector3> other_top(right, points.end());
  points.erase(right, points.end());
  std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 1.0F});
  for (const Vector3& p : sheet(n, 0.0F, 9)) {
    if (p[0] < 0.3F) {
      points.push_back({middle, p[1], -p[0]});
      normals.push_back({1.0F, 0.0F, 0.0F});
    }
  }
  points.insert(points.end(), other_top.begin(), other_top.end());
  normals.resize(points.size(), Vector3{0.0F, 0.0F, 1.0F});
  const NeighbourLists lists = nearestNeighbours(points, 10);
  const auto way_across = [&](const ContactTest& contact) { // mean over several places
    const SurfaceGraph graph = buildCloudSurface(points, lists, normals, 0.0F, contact).graph;
    float sum = 0.0F;
    for (const float y : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F}) {
      const Index other_side = nearestTo(points, {0.7F, y, 0.0F});
      sum += distanceField(graph, nearestTo(points, {0.3F, y, 0.0F}))[static_cast<std::size_t>(other_side)];
    }
    return sum / 5.0F;
  };
  EXPECT_LT(way_across({0.5F, 3.0F}), 0.5F);
  EXPECT_GT(way_across({0.5F, 3.0F, 1.3F}), 0.6F);
}

TEST(CloudContact, DepthTakesNothingFromABendingSurface)
{
  const std::vector<Vector3> points = sphereCloud(1500, 0.5F);
  const CloudSurface surface = surfaceOf(points, {0.5F, 3.0F, 1.3F});
  EXPECT_EQ(surface.graph.neighbours, plainGraph(points).neighbours);
}

/** Copies of a cloud closer together than it is dense by far: the way from copy to copy is the typical spacing, and
 * edges of the cloud itself are ten thousand times as long. */
TEST(CloudContact, DepthEndsWhereEdgesAreVeryMuchLongerThanTheSpacing)
{
  const std::vector<Vector3> once = sphereCloud(300, 0.5F);
  std::mt19937 random(2);
  std::vector<Vector3> points;
  for (int copy = 0; copy < 9; ++copy) {
    for (const Vector3& p : once) {
      points.push_back(
          {p[0] + evenly(random, 0.0F, 1e-5F), p[1] + evenly(random, 0.0F, 1e-5F), p[2] + evenly(random, 0.0F, 1e-5F)});
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  const CloudSurface surface = surfaceOf(points, {0.5F, 3.0F, 0.5F});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20))
      << "minutes when all cubes are searched";
  EXPECT_EQ(surface.graph.size(), points.size());
}

} // namespace
