// Component symmetry: the PCL class on a mesh and on a cloud.
#include "../body.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdio>
#include <exception>

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
makeCloud(const pcl::symmetry::Surface& body)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& point : body.points)
    cloud->emplace_back(point[0], point[1], point[2]);
  return cloud;
}

pcl::PolygonMesh::Ptr
makeMesh(const pcl::symmetry::Surface& body)
{
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(*makeCloud(body), mesh->cloud);
  for (const auto& triangle : body.triangles) {
    pcl::Vertices polygon;
    polygon.vertices.assign(triangle.begin(), triangle.end());
    mesh->polygons.push_back(polygon);
  }
  return mesh;
}

bool
isRight(const char* input, const pcl::symmetry::Surface& body, const pcl::IntrinsicSymmetryResult& result)
{
  const double right = consumer::shareOfRightPartners(body, result.partners);
  std::printf("%s: %s, confidence %.2f, %zu correspondences, %.1f %% of the partners right\n", input,
              toString(result.status), static_cast<double>(result.confidence), result.correspondences.size(),
              100.0 * right);
  return result.status == pcl::symmetry::SymmetryStatus::Symmetric && !result.correspondences.empty() && right > 0.95;
}

} // namespace

int
main()
try {
  const pcl::symmetry::Surface body = consumer::makeBody();
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  pcl::IntrinsicSymmetryResult of_mesh;
  estimation.setInputMesh(makeMesh(body));
  estimation.compute(of_mesh);
  pcl::IntrinsicSymmetryResult of_cloud;
  estimation.setInputCloud(makeCloud(body));
  estimation.compute(of_cloud);
  const bool mesh_right = isRight("mesh", body, of_mesh);
  const bool cloud_right = isRight("cloud", body, of_cloud);
  return mesh_right && cloud_right ? 0 : 1;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "symmetric_body: %s\n", error.what());
  return 1;
}
