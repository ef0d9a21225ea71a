#include "mesh_checks.h"
#include "model/polygonize.h"
#include "model/random_numbers.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

using V = Eigen::Vector3d;

constexpr double pi = 3.14159265358979;

TEST(Polygonize, SphereIsClosedAndOfTheRightSize)
{
  const ImplicitSurface sphere({{V::Zero(), 1.0, V::Zero(), 1.0}}, 0.01);
  const TriangleMesh mesh = polygonize(sphere, 0.1, Extent::Whole);
  const Topology topology = topologyOf(mesh.points.size(), mesh.triangles);
  EXPECT_TRUE(topology.oriented_manifold);
  EXPECT_EQ(topology.boundary_edges, 0U);
  EXPECT_EQ(topology.euler, 2);
  EXPECT_EQ(topology.components, 1U);
  EXPECT_NEAR(volumeOf(mesh), 4.0 / 3.0 * pi, 0.05);
  EXPECT_NEAR(static_cast<double>(mesh.points.size()) * 0.01 / (4.0 * pi), 6.5, 0.5); // as documented
  for (const V& point : mesh.points)
    EXPECT_NEAR(point.norm(), 1.0, 0.01);
}

TEST(Polygonize, HalfHasItsBoundaryOnThePlane)
{
  const ImplicitSurface sphere({{V(-0.4, 0, 0), 1.0, V(0.4, 0, 0), 1.0}}, 0.01);
  const TriangleMesh mesh = polygonize(sphere, 0.13, Extent::PositiveHalf);
  const Topology topology = topologyOf(mesh.points.size(), mesh.triangles);
  EXPECT_TRUE(topology.oriented_manifold);
  EXPECT_EQ(topology.euler, 1); // a disc
  std::size_t in_plane = 0;
  for (const V& point : mesh.points) {
    EXPECT_GE(point.x(), 0.0);
    in_plane += point.x() == 0.0 ? 1 : 0;
  }
  EXPECT_EQ(in_plane, topology.boundary_edges); // one circle: as many vertices as edges
  EXPECT_GT(in_plane, 20U);
}

TEST(Polygonize, IsAManifoldWhateverTheSurface)
{
  // Far too coarse for these cones: topology may be wrong, but never broken.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomNumbers random(seed);
    std::vector<RoundCone> cones;
    while (cones.size() < 40) {
      const V start(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const V end = start + 0.4 * V(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.2, 1));
      cones.emplace_back(start, random.uniform(0.03, 0.05), end, random.uniform(0.05, 0.08));
    }
    const TriangleMesh mesh = polygonize(ImplicitSurface(cones, 0.02), 0.07, Extent::Whole);
    const Topology topology = topologyOf(mesh.points.size(), mesh.triangles);
    EXPECT_TRUE(topology.oriented_manifold) << "seed " << seed;
    EXPECT_EQ(topology.boundary_edges, 0U) << "seed " << seed;
  }
}

} // namespace
