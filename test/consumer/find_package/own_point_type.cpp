// The class for a point type that the library is not instantiated for.
#define PCL_NO_PRECOMPILE
#include "../body.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdio>
#include <exception>

struct PointWithTime {
  PCL_ADD_POINT4D
  double time = 0.0;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(PointWithTime, (float, x, x)(float, y, y)(float, z, z)(double, time, time))

int
main()
try {
  const pcl::symmetry::Surface body = consumer::makeBody();
  auto cloud = pcl::make_shared<pcl::PointCloud<PointWithTime>>();
  for (const auto& position : body.points) {
    PointWithTime point;
    point.getVector3fMap() = Eigen::Vector3f(position[0], position[1], position[2]);
    cloud->push_back(point);
  }
  pcl::IntrinsicSymmetryEstimation<PointWithTime> estimation;
  estimation.setInputCloud(cloud);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  std::printf("%s\n", toString(result.status));
  return result.status == pcl::symmetry::SymmetryStatus::Symmetric ? 0 : 1;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "own_point_type: %s\n", error.what());
  return 1;
}
