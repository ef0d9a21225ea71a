#include "mesh_checks.h"
#include "model/editable_mesh.h"
#include "model/random_numbers.h"
#include "model/remesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

using V = Eigen::Vector3d;

TriangleMesh
tetrahedron()
{
  return {{V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/** \brief Two triangles of the unit square, diagonal from (0, 0) to (1, 1). */
TriangleMesh
square()
{
  return {{V(0, 0, 0), V(1, 0, 0), V(1, 1, 0), V(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}};
}

ImplicitSurface
peanut()
{
  return {{{V(0.5, 0, 0), 0.45, V(0.5, 0, 0), 0.45},
           {V(-0.5, 0, 0), 0.45, V(-0.5, 0, 0), 0.45},
           {V(-0.5, 0, 0), 0.2, V(0.5, 0, 0), 0.2}},
          0.03};
}

double
unitSize(const V&)
{
  return 1.0;
}

TEST(EditableMesh, KnowsNeighboursBoundaryAndOppositeVertices)
{
  const EditableMesh mesh(square());
  EXPECT_EQ(mesh.neighbours(0), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(mesh.valence(0), 3);
  EXPECT_EQ(mesh.valence(1), 2);
  EXPECT_EQ(mesh.countBoundaryVertices(), 4U);
  EXPECT_EQ(mesh.opposite(0, 2), (std::pair<Index, Index>(3, 1)));
  EXPECT_EQ(mesh.opposite(0, 1), (std::pair<Index, Index>(2, no_index)));
  EXPECT_EQ(EditableMesh(tetrahedron()).countBoundaryVertices(), 0U);
}

TEST(EditableMesh, RefusesToCollapseATetrahedron)
{
  EditableMesh mesh(tetrahedron());
  EXPECT_FALSE(mesh.collapse(0, 1, V(0.5, 0, 0)));
  EXPECT_EQ(mesh.compact().triangles, tetrahedron().triangles);
}

TEST(EditableMesh, RefusesInnerEdgesBetweenVerticesOfTheBoundary)
{
  EditableMesh mesh(square());
  EXPECT_FALSE(mesh.flip(0, 2)); // the other diagonal joins two corners as well
  EXPECT_FALSE(mesh.collapse(0, 2, V(0.5, 0.5, 0)));
}

TEST(EditableMesh, FlipTurnsTheDiagonal)
{
  EditableMesh mesh(toMesh(gridMesh(4, 4)));
  ASSERT_EQ(mesh.opposite(5, 10), (std::pair<Index, Index>(9, 6)));
  ASSERT_TRUE(mesh.flip(5, 10));
  EXPECT_EQ(mesh.opposite(5, 10), (std::pair<Index, Index>(no_index, no_index)));
  EXPECT_EQ(mesh.opposite(6, 9), (std::pair<Index, Index>(5, 10)));
  const TriangleMesh flipped = mesh.compact();
  const Topology topology = topologyOf(flipped.points.size(), flipped.triangles);
  EXPECT_TRUE(topology.oriented_manifold);
  EXPECT_EQ(topology.euler, 1);
}

TEST(EditableMesh, RefusesToTurnTrianglesOver)
{
  // Over the edge of a roof the other diagonal would stand upright.
  const TriangleMesh octahedron = {
      {V(1, 0, 0), V(-1, 0, 0), V(0, 1, 0), V(0, -1, 0), V(0, 0, 0.2), V(0, 0, -0.2)},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  EditableMesh mesh(octahedron);
  EXPECT_FALSE(mesh.flip(0, 4));
  EXPECT_EQ(mesh.compact().triangles, octahedron.triangles);
}

TEST(EditableMesh, StaysAManifoldUnderRandomChanges)
{
  for (const Extent extent : {Extent::Whole, Extent::PositiveHalf}) {
    const TriangleMesh start = polygonize(peanut(), 0.12, extent);
    const Topology before = topologyOf(start.points.size(), start.triangles);
    EditableMesh mesh(start);
    RandomNumbers random(11);
    int changes = 0;
    for (int round = 0; round < 4; ++round)
      for (const auto& [a, b] : mesh.edges()) {
        if (!mesh.alive(a) || !mesh.alive(b))
          continue;
        const bool done = random.uniform() < 0.3 ? mesh.collapse(a, b, mesh.point(a)) : mesh.flip(a, b);
        changes += done ? 1 : 0;
      }
    EXPECT_GT(changes, 200);
    const TriangleMesh end = mesh.compact();
    EXPECT_EQ(end.points.size(), mesh.countVertices());
    const Topology after = topologyOf(end.points.size(), end.triangles);
    EXPECT_TRUE(after.oriented_manifold);
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_EQ(after.boundary_edges, mesh.countBoundaryVertices());
    EXPECT_EQ(after.boundary_edges == 0, before.boundary_edges == 0);
  }
}

TEST(Remesh, ReducesToTheNumberAndMakesGoodTriangles)
{
  const ImplicitSurface surface = peanut();
  EditableMesh mesh(polygonize(surface, 0.04, Extent::PositiveHalf));
  ASSERT_TRUE(reduce(mesh, surface, unitSize, 3000));
  const std::size_t mirrored = 2 * mesh.countVertices() - mesh.countBoundaryVertices();
  EXPECT_NEAR(static_cast<double>(mirrored), 3000.0, 1.0);
  const std::vector<double> before = smallestAngles(mesh.compact());
  relax(mesh, surface, unitSize, 6);
  const TriangleMesh relaxed = mesh.compact();
  const std::vector<double> angles = smallestAngles(relaxed);
  EXPECT_GT(angles[angles.size() / 100], 30.0); // all but one in a hundred
  EXPECT_GT(angles[angles.size() / 2], before[before.size() / 2]);
  for (const V& point : relaxed.points) {
    EXPECT_NEAR(surface.value(point), 0.0, 1e-4);
    EXPECT_GE(point.x(), 0.0);
  }
}

TEST(Remesh, SaysWhenTheNumberCannotBeReached)
{
  const ImplicitSurface surface = peanut();
  EditableMesh mesh(polygonize(surface, 0.2, Extent::Whole));
  EXPECT_FALSE(reduce(mesh, surface, unitSize, 2));
}

} // namespace
