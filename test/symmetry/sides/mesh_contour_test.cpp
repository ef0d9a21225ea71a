#include "support/graphs.h"
#include "symmetry/sides/mesh_contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<Index>
nearerEnds(const ZeroLine& line)
{
  std::vector<Index> ends;
  for (const ZeroCrossing& crossing : line.crossings) {
    ends.push_back(crossing.nearerEnd());
  }
  return ends;
}

TEST(MeshContour, RunsFromBorderToBorderAlongTheNearerVertices)
{
  const Surface grid = gridMesh(5, 4);
  std::vector<float> values;
  for (const Vector3& p : grid.points) {
    values.push_back(p[0] - 1.6F);
  }
  const std::vector<ZeroLine> lines = zeroContours(grid.triangles, values);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  std::vector<Index> distinct = nearerEnds(lines[0]);
  for (const ZeroCrossing& crossing : lines[0].crossings) {
    const float x = grid.points[crossing.from][0];
    EXPECT_NEAR(x + crossing.share * (grid.points[crossing.to][0] - x), 1.6F, 1e-5F);
  }
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
  const std::vector<ZeroLine> lines = zeroContours(sphere.triangles, values);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].closed);
  const std::vector<Index> points = nearerEnds(lines[0]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Index v = points[i];
    const Index next = points[(i + 1) % points.size()];
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
  const std::vector<ZeroLine> lines = zeroContours({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {-1.0F, 2.0F, 3.0F, 3.0F, 3.0F});
  ASSERT_EQ(lines.size(), 3U);
  for (const ZeroLine& line : lines) {
    EXPECT_FALSE(line.closed);
    EXPECT_EQ(nearerEnds(line), (std::vector<Index>{0, 0})); // twice the vertex nearest to zero
  }
}

} // namespace
