#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "support/graphs.h"
#include "symmetry/surface/input_cleaning.h"
#include "symmetry/surface/surface_preparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

PreparedSurface
prepare(const Surface& mesh)
{
  return prepareSurface(mesh, SymmetryParameters{}, NeighbourSearch{});
}

TEST(PreparedSurface, LongestSideIsOneAndTheBoxIsCentred)
{
  for (const float scale : {1e-30F, 1.0F, 1e36F}) {
    const Surface mesh = scaled(sphereMesh(3), {scale, 0.5F * scale, 0.25F * scale});
    const PreparedSurface prepared = prepare(mesh);
    ASSERT_EQ(prepared.size(), mesh.size());
    Vector3 low{9, 9, 9};
    Vector3 high{-9, -9, -9};
    for (const Vector3& p : prepared.points) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    EXPECT_NEAR(distance(high, {0.5F, 0.25F, 0.125F}), 0.0F, 1e-5F);
    EXPECT_NEAR(distance(low, {-0.5F, -0.25F, -0.125F}), 0.0F, 1e-5F);
    EXPECT_NEAR(prepared.scale * scale, 0.5F, 1e-5F);
  }
}

TEST(PreparedSurface, KeepsTheLargestComponentInItsOrder)
{
  Surface mesh;
  mesh.points = {{5, 5, 5}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}};
  const Surface grid = gridMesh(7, 5);
  mesh.points.insert(mesh.points.end(), grid.points.begin(), grid.points.end());
  for (const Triangle& t : grid.triangles) {
    mesh.triangles.push_back({t[0] + 2, t[1] + 2, t[2] + 2});
  }
  mesh.triangles.push_back({1, 2, 3}); // of a point that is dropped
  mesh.triangles.push_back({4, 4, 5}); // degenerate
  const PreparedSurface prepared = prepare(mesh);
  ASSERT_EQ(prepared.size(), grid.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_EQ(prepared.original[v], static_cast<Index>(v) + 2);
  }
  EXPECT_EQ(prepared.triangles, grid.triangles);
  EXPECT_EQ(prepared.summary.points, 37U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.unused, 1U);
  EXPECT_EQ(prepared.summary.used, grid.size());
}

TEST(PreparedSurface, APointFarAwayThatNoFaceUsesChangesNothing)
{
  const Surface sphere = sphereMesh(3);
  Surface more = sphere;
  more.points.push_back({1e30F, 0, 0});
  const PreparedSurface prepared = prepare(more);
  EXPECT_EQ(prepared.points, prepare(sphere).points);
  EXPECT_EQ(prepared.summary.unused, 1U);
}

TEST(PreparedSurface, AComponentFarAwayCostsNoPrecision)
{
  const Surface sphere = sphereMesh(4);
  const PreparedSurface expected = prepare(sphere);
  Surface mesh = sphere;
  const auto n = static_cast<Index>(mesh.size());
  mesh.points.insert(mesh.points.end(), {{1e7F, 0, 0}, {1e7F, 1, 0}, {1e7F, 0, 1}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  const PreparedSurface prepared = prepare(mesh);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.summary.other_components, 3U);
}

TEST(PreparedSurface, FacesThatComeTwiceAreTakenOnce)
{
  const Surface grid = gridMesh(7, 5);
  Surface doubled = grid;
  for (const Triangle& t : grid.triangles) {
    doubled.triangles.push_back({t[1], t[2], t[0]});
    doubled.triangles.push_back({t[2], t[1], t[0]}); // as the back of a two-sided surface
  }
  EXPECT_EQ(prepare(doubled).triangles, grid.triangles);
}

/** As exporters write textures: every face with corners of its own. */
TEST(PreparedSurface, VerticesThatAreRepeatedForEveryFaceAreOne)
{
  const Surface mesh = gridMesh(7, 5);
  Surface soup;
  for (const Triangle& t : mesh.triangles) {
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<Index>(soup.points.size());
      soup.points.push_back(mesh.points[t[k]]);
    }
    soup.triangles.push_back(corners);
  }
  const PreparedSurface prepared = prepare(soup);
  ASSERT_EQ(prepared.size(), mesh.size());
  EXPECT_EQ(prepared.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.used, soup.size());
  const Vector3 origin =
      prepared.points[0] - prepared.scale * soup.points[static_cast<std::size_t>(prepared.original[0])];
  for (std::size_t v = 0; v < soup.size(); ++v) {
    const Vector3& stands_for_it = prepared.points[static_cast<std::size_t>(prepared.representatives[v])];
    EXPECT_LT(distance(stands_for_it, origin + prepared.scale * soup.points[v]), 1e-6F);
  }
}

TEST(PreparedSurface, GraphIsThatOfTheMeshAtItsScale)
{
  const Surface grid = gridMesh(7, 5);
  const PreparedSurface prepared = prepare(grid);
  const SurfaceGraph expected = meshGraph(grid);
  EXPECT_FLOAT_EQ(prepared.scale, 1.0F / 6.0F);
  EXPECT_EQ(prepared.graph.offsets, expected.offsets);
  EXPECT_EQ(prepared.graph.neighbours, expected.neighbours);
  for (std::size_t e = 0; e < expected.lengths.size(); ++e) {
    EXPECT_NEAR(prepared.graph.lengths[e], expected.lengths[e] / 6.0F, 1e-6F);
  }
}

TEST(PreparedSurface, NormalsOfASpherePointOutwards)
{
  const PreparedSurface prepared = prepare(sphereMesh(4));
  ASSERT_EQ(prepared.normals.size(), prepared.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_GT(dot(prepared.normals[v], normalized(prepared.points[v])), 0.999F);
    EXPECT_NEAR(norm(prepared.normals[v]), 1.0F, 1e-5F);
  }
}

PreparedSurface
prepareCloud(const std::vector<Vector3>& points)
{
  Surface cloud;
  cloud.points = points;
  return prepareSurface(cloud, SymmetryParameters{}, nearestNeighbours);
}

std::size_t
represented(const PreparedSurface& prepared)
{
  return prepared.representatives.size() -
         static_cast<std::size_t>(
             std::count(prepared.representatives.begin(), prepared.representatives.end(), no_index));
}

// In the unit of the input.
constexpr float cloud_radius = 40.0F;
constexpr float noise = 1.0F;

TEST(UsablePoints, OfAMeshWithoutItsConnectionsAreItsVerticesWithTheNormalsOfItsFaces)
{
  Surface mesh = sphereMesh(3);
  mesh.points.insert(mesh.points.begin(), {{0.2F, 0.1F, 0.0F}, {0.2F, 0.1F, 0.0F}}); // of no face
  for (Triangle& t : mesh.triangles) {
    t = {t[0] + 2, t[1] + 2, t[2] + 2};
  }
  const UsablePoints usable =
      usablePoints(mesh, SymmetryParameters{}, nearestNeighbours, NoiseInterpretation::Close, FaceUse::Normals);
  EXPECT_TRUE(usable.surface.is_cloud);
  EXPECT_TRUE(usable.surface.triangles.empty());
  EXPECT_TRUE(usable.surface.summary.read_as_cloud);
  EXPECT_EQ(usable.surface.summary.faces, mesh.triangles.size());
  ASSERT_EQ(usable.surface.size(), mesh.size() - 2);
  ASSERT_EQ(usable.surface.normals.size(), usable.surface.size());
  for (std::size_t v = 0; v < usable.surface.size(); ++v) {
    EXPECT_EQ(usable.surface.original[v], static_cast<Index>(v + 2));
    EXPECT_GT(dot(usable.surface.normals[v], normalized(usable.surface.points[v])), 0.99F);
  }
  const PreparedSurface prepared = prepareSurface(usable, SymmetryParameters{}, ContactTest{});
  EXPECT_EQ(prepared.size(), usable.surface.size());
  EXPECT_EQ(prepared.summary.components, 1U);
}

TEST(UsablePoints, WithoutAGivenNormalGetOneThatAgreesWithThoseAround)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Surface cloud;
  cloud.points = sphereCloud(1500, cloud_radius);
  for (std::size_t v = 0; v < cloud.size(); ++v) {
    cloud.normals.push_back(v % 7 != 0 ? -1.0F * cloud.points[v] : v % 2 == 0 ? Vector3{nan, 0, 0} : Vector3{0, 0, 0});
  }
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  const PreparedSurface prepared = prepareSurface(cloud, parameters, nearestNeighbours);
  ASSERT_EQ(prepared.size(), cloud.size());
  for (std::size_t v = 0; v < prepared.size(); ++v) {
    EXPECT_NEAR(norm(prepared.normals[v]), 1.0F, 1e-5F);
    EXPECT_LT(dot(prepared.normals[v], normalized(prepared.points[v])), -0.99F) << v; // inwards, as those given
  }
}

TEST(PreparedSurface, NoFaceIsLeftWhereAMeshThatWasSplitIsReadAsACloud)
{
  const PreparedSurface cloud = usablePoints(sphereMesh(3), SymmetryParameters{}, nearestNeighbours,
                                             NoiseInterpretation::Close, FaceUse::Normals, 2000)
                                    .surface;
  EXPECT_GE(cloud.size(), 1500U);
  EXPECT_TRUE(cloud.is_cloud);
  EXPECT_TRUE(cloud.triangles.empty());
  EXPECT_TRUE(cloud.unsplit.empty());
}

TEST(PreparedSurfaceRepresentatives, AreTheVerticesThemselvesOnAMesh)
{
  const Surface mesh = sphereMesh(3);
  const PreparedSurface prepared = prepare(mesh);
  ASSERT_EQ(prepared.representatives.size(), mesh.size());
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    EXPECT_EQ(prepared.representatives[v], static_cast<Index>(v));
  }
  EXPECT_EQ(prepared.summary.used, mesh.size());
  EXPECT_EQ(prepared.summary.working_points, mesh.size());
}

TEST(PreparedSurfaceRepresentatives, AreMissingForWhatIsLeftOutOfAMesh)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Surface grid = gridMesh(7, 5);
  Surface mesh = grid;
  // A triangle apart and a point of no triangle in front, a point that is none in the middle.
  mesh.points.insert(mesh.points.begin() + 10, {nan, 0, 0});
  mesh.points.insert(mesh.points.begin(), {{20, 0, 0}, {21, 0, 0}, {20, 1, 0}, {9, 9, 9}});
  const auto moved = [](Index v) {
    return v < 10 ? v + 4 : v + 5;
  };
  for (Triangle& t : mesh.triangles) {
    t = {moved(t[0]), moved(t[1]), moved(t[2])};
  }
  mesh.triangles.push_back({0, 1, 2});
  const PreparedSurface prepared = prepare(mesh);
  ASSERT_EQ(prepared.representatives.size(), mesh.size());
  for (const Index left_out : {0, 1, 2, 3, 14}) {
    EXPECT_EQ(prepared.representatives[left_out], no_index);
  }
  for (std::size_t v = 0; v < grid.size(); ++v) {
    EXPECT_EQ(prepared.representatives[moved(static_cast<Index>(v))], static_cast<Index>(v));
  }
  EXPECT_EQ(prepared.summary.used, grid.size());
  EXPECT_EQ(prepared.summary.other_components, 3U);
  EXPECT_EQ(prepared.summary.unused, 1U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
}

TEST(PreparedSurfaceRepresentatives, OfACleanCloudAreItsPoints)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Vector3> points = sphereCloud(1500, cloud_radius);
  points.insert(points.begin() + 700, {nan, nan, nan});
  points.insert(points.begin() + 300, {0.0F, 0.0F, 0.0F}); // far from all others
  const std::vector<Vector3> apart = sphereCloud(200, 5.0F, {100.0F, 0.0F, 0.0F});
  points.insert(points.begin(), apart.begin(), apart.end());
  const PreparedSurface prepared = prepareCloud(points);
  ASSERT_EQ(prepared.size(), 1500U);
  EXPECT_EQ(prepared.summary.used, 1500U);
  EXPECT_EQ(prepared.summary.working_points, 1500U);
  EXPECT_EQ(prepared.summary.non_finite, 1U);
  EXPECT_EQ(prepared.summary.outliers, 1U);
  EXPECT_EQ(prepared.summary.other_components, apart.size());
  EXPECT_EQ(prepared.summary.smoothing_radius, 0.0F);
  ASSERT_EQ(prepared.representatives.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool left_out = v < 200 || v == 500 || v == 901;
    ASSERT_EQ(prepared.representatives[v] == no_index, left_out) << v;
    if (!left_out) {
      ASSERT_EQ(prepared.original[prepared.representatives[v]], static_cast<Index>(v));
    }
  }
}

TEST(PreparedSurfaceRepresentatives, OfRepeatedPointsAreTheFirstOnes)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = prepareCloud(sphere);
  std::vector<Vector3> points = sphere;
  for (std::size_t v = 0; v < 1500; v += 2) {
    for (int time = 0; time < 12; ++time) { // more copies than a point has neighbours
      points.push_back(Vector3(sphere[v]));
    }
  }
  const PreparedSurface prepared = prepareCloud(points);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.graph.lengths, expected.graph.lengths);
  EXPECT_EQ(prepared.summary.used, points.size());
  EXPECT_EQ(prepared.summary.outliers, 0U);
  for (std::size_t i = 1500; i < points.size(); ++i) {
    ASSERT_EQ(prepared.representatives[i], static_cast<Index>((i - 1500) / 12 * 2));
  }
}

TEST(PreparedSurfaceRepresentatives, AreMissingForOutliersHoweverFarAway)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = prepareCloud(sphere);
  for (const float far : {1e6F, 1e12F, 1e30F}) {
    std::vector<Vector3> points = sphere;
    points.push_back({far, -far, 0.0F});
    const PreparedSurface prepared = prepareCloud(points);
    EXPECT_EQ(prepared.points, expected.points) << far;
    EXPECT_EQ(prepared.summary.outliers, 1U) << far;
    EXPECT_EQ(prepared.representatives.back(), no_index) << far;
  }
}

TEST(PreparedSurfaceRepresentatives, AnOutlierFarAwayCostsNoPrecision)
{
  const std::vector<Vector3> sphere = sphereCloud(1500, cloud_radius);
  const PreparedSurface expected = prepareCloud(sphere);
  std::vector<Vector3> points = sphere;
  points.push_back({5000.0F * cloud_radius, 0.0F, 0.0F});
  const PreparedSurface prepared = prepareCloud(points);
  EXPECT_EQ(prepared.points, expected.points);
  EXPECT_EQ(prepared.summary.outliers, 1U);
}

TEST(PreparedSurfaceRepresentatives, WhatIsFarFromANoisyCloudDoesNotWidenItsSmoothing)
{
  const std::vector<Vector3> sphere = noisy(sphereCloud(15000, cloud_radius), noise, 1);
  const PreparedSurface expected = prepareCloud(sphere);
  ASSERT_GT(expected.summary.smoothing_radius, 0.0F);
  std::vector<Vector3> points = sphere;
  points.push_back({25.0F * cloud_radius, 0.0F, 0.0F});
  const std::vector<Vector3> other =
      noisy(sphereCloud(2000, cloud_radius, {0.0F, 30.0F * cloud_radius, 0.0F}), noise, 2);
  points.insert(points.end(), other.begin(), other.end());
  const PreparedSurface prepared = prepareCloud(points);
  EXPECT_NEAR(prepared.summary.smoothing_radius, expected.summary.smoothing_radius, 1e-3F * cloud_radius);
  EXPECT_EQ(prepared.size(), expected.size());
  EXPECT_EQ(prepared.summary.outliers, expected.summary.outliers + 1);
  EXPECT_EQ(prepared.summary.other_components, expected.summary.other_components + other.size());
  EXPECT_EQ(prepared.summary.components, expected.summary.components + 1);
}

TEST(PreparedSurfaceRepresentatives, OfANoisyCloudAreShared)
{
  std::vector<Vector3> points = noisy(sphereCloud(15000, cloud_radius), noise, 1);
  const std::vector<Vector3> apart = noisy(sphereCloud(600, 8.0F, {80.0F, 0.0F, 0.0F}), noise, 2);
  points.insert(points.begin() + 5000, apart.begin(), apart.end());
  points[0] = {std::numeric_limits<float>::infinity(), 0.0F, 0.0F};
  const PreparedSurface prepared = prepareCloud(points);
  const InputSummary& summary = prepared.summary;
  EXPECT_GT(summary.smoothing_radius, 2.0F * noise); // in the unit of the input
  EXPECT_LT(summary.smoothing_radius, 0.5F * cloud_radius);
  EXPECT_EQ(summary.working_points, prepared.size());
  EXPECT_LT(prepared.size(), points.size() / 2);
  EXPECT_EQ(summary.used, represented(prepared));
  EXPECT_GT(summary.used, 14000U);
  EXPECT_EQ(summary.used + summary.non_finite + summary.outliers + summary.other_components, points.size());

  ASSERT_EQ(prepared.representatives.size(), points.size());
  EXPECT_EQ(prepared.representatives[0], no_index);
  for (std::size_t v = 5000; v < 5600; ++v) {
    ASSERT_EQ(prepared.representatives[v], no_index); // of the smaller sphere
  }
  for (std::size_t w = 0; w < prepared.size(); ++w) {
    ASSERT_EQ(prepared.representatives[prepared.original[w]], static_cast<Index>(w));
  }
  // Near what they stand for, but for the shift of the box: differences between two of them are those of their points.
  const Index first = prepared.representatives[100];
  ASSERT_NE(first, no_index);
  for (std::size_t v = 101; v < 5000; v += 7) {
    const Index other = prepared.representatives[v];
    if (other != no_index) {
      const Vector3 here = (1.0F / prepared.scale) * (prepared.points[other] - prepared.points[first]);
      ASSERT_LT(distance(here, points[v] - points[100]), 2.0F * summary.smoothing_radius);
    }
  }
}

/** A sphere of which one octant was left coarse, every triangle with corners of its own, which rounding has moved. */
TEST(PreparedSurface, CracksDoNotTearASurface)
{
  Surface sphere = sphereMesh(0);
  sphere = scaled(sphere, {1.0F, 0.8F, 0.6F});
  Surface facets;
  const auto add = [&facets](const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto first = static_cast<Index>(facets.size());
    for (const Vector3& p : {a, b, c}) {
      const float off = 1e-6F * static_cast<float>(facets.size() % 7);
      facets.points.push_back({p[0] + off, p[1] - off, p[2] + off});
    }
    facets.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    const Vector3 a = sphere.points[sphere.triangles[i][0]];
    const Vector3 b = sphere.points[sphere.triangles[i][1]];
    const Vector3 c = sphere.points[sphere.triangles[i][2]];
    if (i == 0) {
      add(a, b, c);
      continue;
    }
    const Vector3 ab = 0.5F * (a + b);
    const Vector3 bc = 0.5F * (b + c);
    const Vector3 ca = 0.5F * (c + a);
    add(a, ab, ca);
    add(ab, b, bc);
    add(ca, bc, c);
    add(ab, bc, ca);
  }
  const PreparedSurface prepared = prepare(facets);
  EXPECT_EQ(prepared.size(), 18U);
  EXPECT_EQ(prepared.summary.welded, facets.size() - 18U);
  EXPECT_EQ(prepared.summary.junctions, 3U);
  EXPECT_EQ(prepared.summary.components, 1U);
  EXPECT_EQ(prepared.summary.used, facets.size());
  for (const Vector3& p : facets.points) {
    const Index v = prepared.representatives[static_cast<std::size_t>(&p - facets.points.data())];
    EXPECT_LT(distance(prepared.points[v], prepared.scale * p), 1e-4F);
  }
}

} // namespace
