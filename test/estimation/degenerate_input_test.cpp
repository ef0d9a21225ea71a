// Input of which nothing, or little, can be made: a stated outcome, never a crash or a number that is none.
#include "support/known_body.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Every array has one entry per point, every number is one. */
void
expectSound(const SymmetryResult& result, std::size_t points)
{
  ASSERT_EQ(result.partners.size(), points);
  ASSERT_EQ(result.confidences.size(), points);
  ASSERT_EQ(result.sides.size(), points);
  ASSERT_EQ(result.regions.size(), points);
  for (std::size_t v = 0; v < points; ++v) {
    ASSERT_TRUE(result.partners[v] >= no_index && result.partners[v] < static_cast<Index>(points));
    ASSERT_TRUE(result.confidences[v] >= 0.0F && result.confidences[v] <= 1.0F) << result.confidences[v];
  }
  EXPECT_TRUE(result.confidence >= 0.0F && result.confidence <= 1.0F) << result.confidence;
  EXPECT_TRUE(result.diameter >= 0.0F && std::isfinite(result.diameter)) << result.diameter;
  EXPECT_EQ(result.message.empty(), result.status == SymmetryStatus::Symmetric) << result.message;
}

class DegenerateInputTest : public testing::TestWithParam<Method> {
protected:
  SymmetryResult
  estimate(const Surface& surface) const
  {
    SymmetryParameters parameters;
    parameters.method = GetParam();
    SymmetryResult result = estimateIntrinsicSymmetry(surface, parameters);
    expectSound(result, surface.size());
    return result;
  }
};

TEST_P(DegenerateInputTest, NoPoints)
{
  EXPECT_EQ(estimate({}).status, SymmetryStatus::TooFewPoints);
}

TEST_P(DegenerateInputTest, FewerPointsThanNeighbours)
{
  Surface cloud;
  for (int i = 0; i < 9; ++i) {
    const auto x = static_cast<float>(i);
    cloud.points.push_back({x, x * x, 1.0F});
    EXPECT_EQ(estimate(cloud).status, SymmetryStatus::TooFewPoints) << i;
  }
}

TEST_P(DegenerateInputTest, OneTriangle)
{
  Surface mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(estimate(mesh).status, SymmetryStatus::TooFewPoints);
}

TEST_P(DegenerateInputTest, NoFinitePoint)
{
  Surface cloud;
  cloud.points.assign(500, {std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F});
  const SymmetryResult result = estimate(cloud);
  EXPECT_EQ(result.status, SymmetryStatus::TooFewPoints);
  EXPECT_EQ(result.input.non_finite, 500U);
}

TEST_P(DegenerateInputTest, AllPointsEqual)
{
  Surface cloud;
  cloud.points.assign(500, {1.0F, 2.0F, 3.0F});
  EXPECT_NE(estimate(cloud).status, SymmetryStatus::Symmetric);
}

TEST_P(DegenerateInputTest, MeshOfEqualPoints)
{
  Surface mesh = sphereMesh(3);
  for (Vector3& p : mesh.points) {
    p = {1.0F, 2.0F, 3.0F};
  }
  EXPECT_NE(estimate(mesh).status, SymmetryStatus::Symmetric);
}

TEST_P(DegenerateInputTest, PointsOnALine)
{
  Surface cloud;
  for (int i = 0; i < 500; ++i) {
    cloud.points.push_back({static_cast<float>(i), 2.0F * static_cast<float>(i), 0.0F});
  }
  estimate(cloud);
}

TEST_P(DegenerateInputTest, MeshOnALine)
{
  Surface mesh = gridMesh(30, 20);
  for (Vector3& p : mesh.points) {
    p = {p[0] + 0.37F * p[1], 0.0F, 0.0F};
  }
  estimate(mesh);
}

TEST_P(DegenerateInputTest, HugeAndTinyCoordinates)
{
  for (const float scale : {1e-30F, 1e37F}) {
    estimate(scaled(sphereMesh(3), {scale, scale, scale}));
  }
}

TEST_P(DegenerateInputTest, TrianglesThatAreNone)
{
  Surface mesh = body(Body::Human, 0.0).surface;
  const std::size_t faces = mesh.triangles.size();
  for (Index v = 0; v < 50; ++v) {
    mesh.triangles.push_back({v, v, v + 1});
    mesh.triangles.push_back({v, v, v});
  }
  const SymmetryResult result = estimate(mesh);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.input.faces, faces + 100);
}

TEST_P(DegenerateInputTest, EdgesOfLengthZero)
{
  Surface mesh = body(Body::Human, 0.0).surface;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 40) {
    mesh.points[mesh.triangles[i][0]] = mesh.points[mesh.triangles[i][1]];
  }
  EXPECT_EQ(estimate(mesh).status, SymmetryStatus::Symmetric);
}

TEST_P(DegenerateInputTest, NonManifoldMesh)
{
  // Fins on edges, a face given twice, a face turned over.
  Surface mesh = body(Body::Human, 0.0).surface;
  for (std::size_t i = 0; i < 500; i += 50) {
    const Triangle t = mesh.triangles[i];
    mesh.points.push_back(1.1F * mesh.points[t[0]]);
    mesh.triangles.push_back({t[0], t[1], static_cast<Index>(mesh.size() - 1)});
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  EXPECT_EQ(estimate(mesh).status, SymmetryStatus::Symmetric);
}

TEST_P(DegenerateInputTest, FacesTurnedAtRandom)
{
  Surface mesh = body(Body::Human, 0.0).surface;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i * i % 7 < 3) {
      std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
  }
  estimate(mesh);
}

TEST_P(DegenerateInputTest, PointsOnNoFace)
{
  Surface mesh = body(Body::Human, 0.0).surface;
  const std::size_t used = mesh.size();
  for (int i = 0; i < 200; ++i) {
    mesh.points.push_back({static_cast<float>(i), -3.0F, 2.0F});
  }
  const SymmetryResult result = estimate(mesh);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.input.used, used);
  EXPECT_EQ(result.input.unused, 200U);
  EXPECT_EQ(result.partners.back(), no_index);
}

TEST_P(DegenerateInputTest, ATriangleWithAPointThatIsNotThereIsRefused)
{
  Surface mesh = sphereMesh(2);
  for (const Index corner : {no_index, static_cast<Index>(mesh.size())}) {
    mesh.triangles[3][2] = corner;
    EXPECT_THROW(estimate(mesh), pcl::BadArgumentException);
  }
}

TEST_P(DegenerateInputTest, NormalsOfAnotherNumberThanPointsAreRefused)
{
  Surface cloud = sphereMesh(3);
  cloud.triangles.clear();
  cloud.normals.assign(cloud.size() - 1, {0.0F, 0.0F, 1.0F});
  EXPECT_THROW(estimate(cloud), pcl::BadArgumentException);
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         DegenerateInputTest,
                         testing::Values(Method::Robust, Method::Staged),
                         [](const testing::TestParamInfo<Method>& tested) {
                           return tested.param == Method::Robust ? "Robust" : "Staged";
                         });

TEST(GivenNormals, AreRefusedWhereThereAreNone)
{
  Surface cloud = sphereMesh(3);
  cloud.triangles.clear();
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  EXPECT_THROW(estimateIntrinsicSymmetry(cloud, parameters), pcl::BadArgumentException);
}

} // namespace
