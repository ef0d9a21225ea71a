#include "support/graphs.h"
#include "symmetry/sides/mesh_contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(MeshContour, RunsFromBorderToBorderAlongTheNearerVertices)
{
  const Surface grid = gridMesh(5, 4);
  std::vector<float> values;
  for (const Vector3& p : grid.points) {
    values.push_back(p[0] - 1.6F);
  }
  const std::vector<Polyline> lines = zeroContours(grid.triangles, values);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  std::vector<Index> distinct = lines[0].points;
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.front() > distinct.back()) {
    std::reverse(distinct.begin(), distinct.end());
  }
  EXPECT_EQ(distinct, (std::vector<Index>{2, 7, 12, 17})); // the column x = 2
}

TEST(MeshContour, ClosesOnASphere)
{
  const Surface sphere = sphereMesh(4);
  const SurfaceGraph graph = meshGraph(sphere);
  std::vector<float> values;
  for (const Vector3& p : sphere.points) {
    values.push_back(p[2] - 0.41F);
  }
  const std::vector<Polyline> lines = zeroContours(sphere.triangles, values);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].closed);
  for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
    const Index v = lines[0].points[i];
    const Index next = lines[0].points[(i + 1) % lines[0].points.size()];
    EXPECT_TRUE(v == next || areNeighbours(graph, v, next)) << i;
    EXPECT_LT(std::abs(values[v]), 0.1F) << i;
  }
}

TEST(MeshContour, IsNoneWhereTheSignIsTheSame)
{
  const Surface grid = gridMesh(4, 4);
  EXPECT_TRUE(zeroContours(grid.triangles, std::vector<float>(16, 0.0F)).empty()); // zero counts as positive
  EXPECT_TRUE(zeroContours(grid.triangles, std::vector<float>(16, -1.0F)).empty());
}

TEST(MeshContour, EndsAtAnEdgeOfThreeTriangles)
{
  // Three pages of a book, the spine crossed in the middle.
  const std::vector<Polyline> lines = zeroContours({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {-1.0F, 2.0F, 3.0F, 3.0F, 3.0F});
  ASSERT_EQ(lines.size(), 3U);
  for (const Polyline& line : lines) {
    EXPECT_FALSE(line.closed);
    EXPECT_EQ(line.points, (std::vector<Index>{0, 0})); // twice the vertex nearest to zero
  }
}

} // namespace
