// Meshes that the class takes, and refuses.
#include "estimation/class_runs.h"
#include "support/messages.h"

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <array>
#include <cstring>
#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(MeshInput, RefusesAPolygonWithAPointThatIsNotThere)
{
  for (const int corner : {-1, static_cast<int>(bentHuman().surface.size())}) {
    const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
    mesh->polygons[5].vertices[1] = static_cast<pcl::index_t>(corner);
    pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
    expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setInputMesh(mesh); }),
                    {"polygon 5", std::to_string(bentHuman().surface.size())});
  }
}

TEST(MeshInput, RefusesAMeshWithoutFloatCoordinates)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  EXPECT_THROW(estimation.setInputMesh(pcl::PolygonMesh::ConstPtr()), pcl::BadArgumentException);
  EXPECT_THROW(estimation.setInputMesh(pcl::make_shared<pcl::PolygonMesh>()), pcl::BadArgumentException);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->cloud.fields[1].datatype = pcl::PCLPointField::FLOAT64;
  expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setInputMesh(mesh); }), {"float", "y"});
}

/** The mesh with double positions, all of them moved; x y z in another order, behind a field of another type. */
pcl::PolygonMesh::Ptr
inDoubles(const pcl::PolygonMesh& mesh, const std::array<double, 3>& place)
{
  const auto moved = pcl::make_shared<pcl::PolygonMesh>();
  moved->polygons = mesh.polygons;
  moved->cloud.width = mesh.cloud.width;
  moved->cloud.height = mesh.cloud.height;
  moved->cloud.point_step = 28;
  moved->cloud.row_step = 28 * mesh.cloud.width;
  moved->cloud.data.resize(std::size_t{moved->cloud.row_step} * moved->cloud.height);
  const char* names[] = {"intensity", "z", "x", "y"};
  const std::size_t axes[] = {0, 2, 0, 1};
  for (std::size_t f = 0; f < 4; ++f) {
    pcl::PCLPointField field;
    field.name = names[f];
    field.offset = f == 0 ? 0 : static_cast<pcl::uindex_t>(8 * f - 4);
    field.datatype = f == 0 ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::FLOAT64;
    field.count = 1;
    moved->cloud.fields.push_back(field);
    for (std::size_t v = 0; f > 0 && v < mesh.cloud.width; ++v) {
      float from = 0.0F;
      std::memcpy(&from, mesh.cloud.data.data() + v * mesh.cloud.point_step + 4 * axes[f], sizeof from);
      const double to = double{from} + place[axes[f]];
      std::memcpy(moved->cloud.data.data() + v * 28 + field.offset, &to, sizeof to);
    }
  }
  return moved;
}

TEST(MeshInput, TakesDoublePositionsAtMapCoordinates)
{
  const std::array<double, 3> place{326499.0, 5822000.0, 34.0}; // floats there are half a metre apart
  pcl::IntrinsicSymmetryResult at_origin;
  pcl::IntrinsicSymmetryResult on_the_map;
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  estimation.compute(at_origin);
  EXPECT_EQ(estimation.getInputOffset(), (std::array<double, 3>{}));
  estimation.setInputMesh(inDoubles(*humanMesh(), place));
  estimation.compute(on_the_map);
  EXPECT_NEAR(estimation.getInputOffset()[0], place[0], 2.0);
  EXPECT_NEAR(estimation.getInputOffset()[1], place[1], 2.0);
  std::size_t same = 0;
  for (std::size_t v = 0; v < at_origin.partners.size(); ++v) {
    same += at_origin.partners[v] == on_the_map.partners[v] ? 1U : 0U;
  }
  EXPECT_GT(same, at_origin.partners.size() * 9 / 10); // rounding moves a few to a neighbour
  double moved_offset = at_origin.plane.offset;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(on_the_map.plane.normal[k], at_origin.plane.normal[k], 1e-2);
    moved_offset += on_the_map.plane.normal[k] * place[k];
  }
  EXPECT_NEAR(on_the_map.plane.offset, moved_offset, 0.02);
  estimation.setInputCloud(pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>());
  EXPECT_EQ(estimation.getInputOffset(), (std::array<double, 3>{}));
}

TEST(MeshInput, AMeshThatIsRefusedLeavesTheEarlierInput)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->polygons[5].vertices[1] = 100000;
  EXPECT_THROW(estimation.setInputMesh(mesh), pcl::BadArgumentException);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_EQ(result.partners, compute(humanMesh()).partners);
}

TEST(MeshInput, PolygonsAreTriangulatedAsFans)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->polygons.clear();
  // Triangles in pairs that share an edge become quads, whose fan is either that pair or the other diagonal's.
  const std::vector<Triangle>& triangles = bentHuman().surface.triangles;
  std::vector<char> used(triangles.size(), 0);
  std::size_t quads = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; used[i] == 0 && j < std::min(i + 40, triangles.size()); ++j) {
      for (std::size_t a = 0; a < 3 && used[i] == 0; ++a) {
        for (std::size_t b = 0; b < 3 && used[i] == 0 && used[j] == 0; ++b) {
          const Triangle& s = triangles[i];
          const Triangle& t = triangles[j];
          if (s[a] == t[(b + 1) % 3] && s[(a + 1) % 3] == t[b]) {
            mesh->polygons.push_back(polygon({s[(a + 1) % 3], s[(a + 2) % 3], s[a], t[(b + 2) % 3]}));
            used[i] = used[j] = 1;
            ++quads;
          }
        }
      }
    }
    if (used[i] == 0) {
      mesh->polygons.push_back(polygon({triangles[i][0], triangles[i][1], triangles[i][2]}));
    }
  }
  ASSERT_GT(quads, triangles.size() / 8);
  mesh->polygons.push_back(polygon({0, 1})); // encloses nothing
  const pcl::IntrinsicSymmetryResult result = compute(mesh);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.input.faces, triangles.size());
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), result.partners)), 0.95);
}

} // namespace
