// The PCL class on a point cloud without faces: its nearest neighbours make a graph, along which distances are
// measured.
#include <pcl/symmetry/intrinsic_symmetry.h>

#include <pcl/common/distances.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cstdio>
#include <exception>

int
main(int argc, char** argv)
try {
  if (argc != 2) {
    std::fputs("usage: cloud_correspondences INPUT.pcd\n", stderr);
    return 2;
  }
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::fprintf(stderr, "cloud_correspondences: cannot read %s\n", argv[1]);
    return 1;
  }

  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);     // setIndices restricts it to a part
  estimation.setKSearch(10);           // the default: more bridges gaps, and contacts between parts as well
  estimation.setNumberOfThreads(0);    // the default: all cores; the result does not depend on it
  pcl::IntrinsicSymmetryResult result; // indices in it refer to the cloud, whatever is left out on the way
  estimation.compute(result);
  std::printf("%s, confidence %.2f\n", toString(result.status), static_cast<double>(result.confidence));
  std::printf("%zu of %zu points used, %zu outliers\n", result.input.used, result.input.points, result.input.outliers);
  if (!pcl::symmetry::hasMap(result.status)) {
    std::printf("%s\n", result.message.c_str());
    return 3;
  }

  // The sparse matches as PCL's other algorithms take them; result.partners has one for every point.
  pcl::Correspondences correspondences = result.correspondences;
  std::sort(correspondences.begin(), correspondences.end(),
            [](const auto& a, const auto& b) { return a.distance < b.distance; });
  std::printf("%zu correspondences, those of least cost:\n", correspondences.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(5, correspondences.size()); ++i) {
    const pcl::Correspondence& match = correspondences[i];
    std::printf("%5d <-> %5d, straight distance %.3f\n", match.index_query, match.index_match,
                static_cast<double>(pcl::euclideanDistance((*cloud)[match.index_query], (*cloud)[match.index_match])));
  }
  return 0;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "cloud_correspondences: %s\n", error.what());
  return 1;
}
