// Is not to compile: the library does not hold the class for this type of points.
#include <pcl/symmetry/intrinsic_symmetry.h>

int
main()
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointWithScale> estimation;
  return estimation.getKSearch();
}
