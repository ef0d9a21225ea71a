// The PCL class on a triangle mesh: labels each vertex with its side and writes them as a cloud that PCL loads again.
#include <pcl/symmetry/intrinsic_symmetry.h>

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cstdio>
#include <exception>

using pcl::symmetry::Side;

namespace {

/** The vertices of the mesh, each with its side as label: 0 none, 1 source, 2 target, 3 axis. */
pcl::PointCloud<pcl::PointXYZL>
labelledVertices(const pcl::PolygonMesh& mesh, const std::vector<Side>& sides)
{
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  pcl::copyPointCloud(vertices, cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].label = static_cast<std::uint32_t>(sides[i]);
  }
  return cloud;
}

} // namespace

int
main(int argc, char** argv)
try {
  if (argc != 3) {
    std::fputs("usage: mesh_sides INPUT.ply OUTPUT.ply\n", stderr);
    return 2;
  }
  // PCL's reader wants float coordinates; pcl::symmetry::readSurface (component io) takes any type, and more formats.
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  if (pcl::io::loadPLYFile(argv[1], *mesh) != 0) {
    std::fprintf(stderr, "mesh_sides: cannot read %s\n", argv[1]);
    return 1;
  }

  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setInputMesh(mesh);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result); // a caller's mistake throws, an outcome of the data is a status:
  std::printf("%s, confidence %.2f\n", toString(result.status), static_cast<double>(result.confidence));
  if (!pcl::symmetry::hasMap(result.status)) {
    std::printf("%s\n", result.message.c_str());
    return 3;
  }

  for (const Side side : {Side::Source, Side::Target, Side::Axis}) {
    std::printf("label %d: %td vertices\n", static_cast<int>(side),
                std::count(result.sides.begin(), result.sides.end(), side));
  }
  for (const pcl::symmetry::Polyline& line : result.axis) {
    std::printf("axis: %zu vertices, %s\n", line.points.size(), line.closed ? "closed" : "open");
  }

  // As a cloud: savePLYFile of a mesh would drop the label. writeLabelledSurface (component io) keeps the faces, too.
  if (pcl::io::savePLYFileBinary(argv[2], labelledVertices(*mesh, result.sides)) != 0) {
    std::fprintf(stderr, "mesh_sides: cannot write %s\n", argv[2]);
    return 1;
  }
  return 0;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "mesh_sides: %s\n", error.what());
  return 1;
}
