#include "support/coarse_body.h"
#include "symmetry/samples/coarse_surface.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

CoarseSurface
coarseSphere(std::size_t samples)
{
  return coarsenSurface(preparedMesh(sphereMesh(5)), samples);
}

TEST(CoarseSurface, ArraysAgreeAndAreasSumUpToOne)
{
  const CoarseSurface coarse = coarseSphere(500);
  ASSERT_EQ(coarse.size(), 500U);
  ASSERT_EQ(coarse.graph.size(), 500U);
  ASSERT_EQ(coarse.areas.size(), 500U);
  ASSERT_EQ(coarse.normals.size(), 500U);
  ASSERT_EQ(coarse.conductances.size(), coarse.graph.neighbours.size());
  EXPECT_NEAR(std::accumulate(coarse.areas.begin(), coarse.areas.end(), 0.0), 1.0, 1e-5);
  for (const float area : coarse.areas) {
    EXPECT_GT(area, 0.1F / 500.0F);
    EXPECT_LT(area, 4.0F / 500.0F);
  }
}

TEST(CoarseSurface, NormalsOfASpherePointOutwards)
{
  const CoarseSurface coarse = coarseSphere(500);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(norm(coarse.normals[i]), 1.0F, 1e-5F);
    EXPECT_GT(dot(coarse.normals[i], normalized(coarse.points[i])), 0.97F);
  }
}

TEST(CoarseSurface, ConductancesArePositiveAndSymmetric)
{
  const CoarseSurface coarse = coarseSphere(500);
  std::map<std::pair<Index, Index>, float> conductance;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    for (std::uint32_t e = coarse.graph.offsets[i]; e < coarse.graph.offsets[i + 1]; ++e) {
      EXPECT_GT(coarse.conductances[e], 0.0F);
      conductance[{static_cast<Index>(i), coarse.graph.neighbours[e]}] = coarse.conductances[e];
    }
  }
  for (const auto& [edge, value] : conductance) {
    EXPECT_FLOAT_EQ(value, (conductance.at({edge.second, edge.first})));
  }
}

TEST(CoarseSurface, TrianglesOfASphereCloseItAndFaceOutwards)
{
  const CoarseSurface coarse = coarseSphere(300);
  std::map<std::pair<Index, Index>, int> uses;
  std::size_t outwards = 0;
  for (const Triangle& t : coarse.triangles) {
    const Vector3& p = coarse.points[t[0]];
    outwards += dot(cross(coarse.points[t[1]] - p, coarse.points[t[2]] - p), p) > 0.0F ? 1U : 0U;
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  const auto shared = std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second == 2; });
  EXPECT_GE(static_cast<double>(shared), 0.95 * static_cast<double>(uses.size()));
  EXPECT_GE(static_cast<double>(outwards), 0.98 * static_cast<double>(coarse.triangles.size()));
  // Euler: V - E + F = 2, but for a few places where four cells meet.
  EXPECT_NEAR(static_cast<double>(coarse.triangles.size()), 2.0 * 300.0 - 4.0, 15.0);
}

TEST(CoarseSurface, SamplesDoNotDependOnTheOrderOfThePoints)
{
  const Surface mesh = body(Body::Quadruped, 1.0).surface;
  const auto n = static_cast<Index>(mesh.size());
  Surface reversed = mesh;
  std::reverse(reversed.points.begin(), reversed.points.end());
  for (Triangle& t : reversed.triangles) {
    t = {n - 1 - t[0], n - 1 - t[1], n - 1 - t[2]};
  }
  const CoarseSurface a = coarsenSurface(preparedMesh(mesh), 100);
  const CoarseSurface b = coarsenSurface(preparedMesh(reversed), 100);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.cells.vertices[i], n - 1 - b.cells.vertices[i]);
  }
}

TEST(CoarseSurface, AFlatSurfaceHasEqualShares)
{
  PreparedSurface line = preparedMesh(gridMesh(20, 10));
  for (Vector3& p : line.points) {
    p = {p[0] + 0.01F * p[1], 0.0F, 0.0F};
  }
  const CoarseSurface coarse = coarsenSurface(line, 50);
  EXPECT_NEAR(std::accumulate(coarse.areas.begin(), coarse.areas.end(), 0.0), 1.0, 1e-5);
}

TEST(DualTriangles, OneForThreeCellsThatMeet)
{
  const std::vector<Index> owner{0, 1, 2, 2, 1};
  // The second triangle joins the same cells in the same order, the third has two corners in one cell.
  const std::vector<Triangle> dual = dualTriangles({{0, 1, 2}, {4, 3, 0}, {1, 4, 2}}, owner);
  EXPECT_EQ(dual, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(DualTriangles, AreFewPerCellWhereFacesJoinAnythingWithAnything)
{
  constexpr Index n = 40;
  std::vector<Index> owner(n);
  std::iota(owner.begin(), owner.end(), 0);
  std::vector<Triangle> all;
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      for (Index k = j + 1; k < n; ++k) {
        all.push_back({i, j, k});
      }
    }
  }
  const std::vector<Triangle> dual = dualTriangles(all, owner);
  EXPECT_LE(dual.size(), 8U * owner.size());
  EXPECT_GE(dual.size(), 4U * owner.size());
  EXPECT_EQ(dual.front(), all.front());
  EXPECT_GT(dual.back()[0], n / 2) << "of all of them, not of the first ones";
}

} // namespace
