/** \file
 * \brief Surfaces as PCL's clouds and meshes.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

template <typename PointT = PointXYZ>
typename PointCloud<PointT>::Ptr
cloudOf(const std::vector<Vector3>& points)
{
  const auto cloud = make_shared<PointCloud<PointT>>();
  for (const Vector3& p : points) {
    PointT point;
    point.x = p[0];
    point.y = p[1];
    point.z = p[2];
    cloud->push_back(point);
  }
  return cloud;
}

inline Vertices
polygon(const Indices& corners)
{
  Vertices polygon;
  polygon.vertices = corners;
  return polygon;
}

inline PolygonMesh::Ptr
meshOf(const Surface& surface)
{
  const auto mesh = make_shared<PolygonMesh>();
  toPCLPointCloud2(*cloudOf(surface.points), mesh->cloud);
  for (const Triangle& t : surface.triangles) {
    mesh->polygons.push_back(polygon({t[0], t[1], t[2]}));
  }
  return mesh;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
