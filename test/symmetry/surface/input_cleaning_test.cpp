#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "support/graphs.h"
#include "symmetry/surface/input_cleaning.h"
#include "symmetry/surface/surface_preparation.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

// In the unit of the input.
constexpr float cloud_radius = 40.0F;

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

TEST(UsablePoints, HaveNoFaceWhereAMeshThatWasSplitIsReadAsACloud)
{
  const PreparedSurface cloud = usablePoints(sphereMesh(3), SymmetryParameters{}, nearestNeighbours,
                                             NoiseInterpretation::Close, FaceUse::Normals, 2000)
                                    .surface;
  EXPECT_GE(cloud.size(), 1500U);
  EXPECT_TRUE(cloud.is_cloud);
  EXPECT_TRUE(cloud.triangles.empty());
  EXPECT_TRUE(cloud.unsplit.empty());
}

} // namespace
