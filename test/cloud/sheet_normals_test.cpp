#include "cloud/cloud_normals.h"
#include "cloud/clouds.h"
#include "cloud/sheet_normals.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr int k = 10;
constexpr float spacing = 0.02F;

/** Two spheres, five spacings in radius, that nearly touch. */
struct Spheres {
  std::vector<Vector3> points;
  std::vector<Vector3> normals; ///< the true ones
};

Spheres
spheresInContact(float gap)
{
  constexpr float radius = 0.1F;
  constexpr std::size_t number = 320; // some 0.02 apart
  Spheres spheres;
  for (const float side : {-1.0F, 1.0F}) {
    const Vector3 centre{side * (radius + 0.5F * gap), 0.0F, 0.0F};
    for (const Vector3& p : sphereCloud(number, radius, centre)) {
      spheres.points.push_back(p);
      spheres.normals.push_back(normalized(p - centre));
    }
  }
  return spheres;
}

/** Cosine of the angle between a normal, of either sign, and the true one, at worst. */
float
leastCosine(const std::vector<Vector3>& normals, const std::vector<Vector3>& truth)
{
  float least = 1.0F;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    least = std::min(least, std::abs(dot(normals[v], truth[v])));
  }
  return least;
}

TEST(SheetNormals, AreThoseOfOneOfTwoBodiesInContact)
{
  for (const float gap : {0.004F, 0.008F, 0.012F, 0.016F}) {
    SCOPED_TRACE(gap);
    const Spheres spheres = spheresInContact(gap);
    const NeighbourLists lists = nearestNeighbours(spheres.points, k);
    const std::vector<Vector3> blended = estimateNormals(spheres.points, lists);
    EXPECT_LT(leastCosine(blended, spheres.normals), 0.95F);
    EXPECT_GT(leastCosine(sheetNormals(spheres.points, lists, blended), spheres.normals), 0.97F);
  }
}

TEST(SheetNormals, StayOnASmoothSurface)
{
  const std::vector<Vector3> points = sphereCloud(2000, 0.4F);
  const NeighbourLists lists = nearestNeighbours(points, k);
  const std::vector<Vector3> normals = sheetNormals(points, lists, estimateNormals(points, lists));
  for (std::size_t v = 0; v < points.size(); ++v) {
    ASSERT_GT(std::abs(dot(normals[v], normalized(points[v]))), 0.99F) << v;
    ASSERT_NEAR(norm(normals[v]), 1.0F, 1e-4F) << v;
  }
}

/** One direction with opposite signs must not cancel out. */
TEST(SheetNormals, AreMeansOfEitherSign)
{
  const std::vector<Vector3> points = sphereCloud(500, 0.4F);
  std::vector<Vector3> normals;
  for (std::size_t v = 0; v < points.size(); ++v) {
    normals.push_back((v % 2 == 0 ? 1.0F : -1.0F) * normalized(points[v]));
  }
  const std::vector<Vector3> means = sheetNormals(points, nearestNeighbours(points, k), normals);
  for (std::size_t v = 0; v < points.size(); ++v) {
    ASSERT_GT(dot(means[v], normals[v]), 0.98F) << v; // and keep the sign of their own
  }
}

TEST(SheetNormals, AreOfLengthOneWhereThereIsNoPlane)
{
  std::vector<Vector3> points(4, Vector3{0.5F, 0.5F, 0.5F});
  for (int i = 0; i < 8; ++i) {
    points.push_back({static_cast<float>(i) * spacing, 0.0F, 0.0F});
  }
  points.push_back({0.0F, 0.0F, std::numeric_limits<float>::min()});
  const NeighbourLists lists = nearestNeighbours(points, 3);
  for (const Vector3& normal : sheetNormals(points, lists, estimateNormals(points, lists))) {
    EXPECT_NEAR(norm(normal), 1.0F, 1e-4F);
  }
  NeighbourLists none;
  none.k = 3;
  none.neighbours.assign(3, no_index);
  const Vector3 up{0.0F, 0.0F, 1.0F};
  EXPECT_EQ(sheetNormals({{0.0F, 0.0F, 0.0F}}, none, {up}).front(), up);
}

TEST(SheetNormals, AreTheSameForAnyNumberOfThreads)
{
  const std::vector<Vector3> points = spheresInContact(0.01F).points;
  const NeighbourLists lists = nearestNeighbours(points, k);
  const std::vector<Vector3> normals = estimateNormals(points, lists);
  EXPECT_EQ(sheetNormals(points, lists, normals), withThreads(3, [&] { return sheetNormals(points, lists, normals); }));
}

} // namespace
