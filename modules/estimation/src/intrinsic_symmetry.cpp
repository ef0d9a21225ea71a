#include <pcl/symmetry/impl/intrinsic_symmetry.hpp>
#include <pcl/symmetry/intrinsic_symmetry.h>

PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZ) PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZI)
    PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZL)
        PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZRGB)
            PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZRGBA)
                PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZRGBL)
                    PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointNormal)
                        PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZINormal)
                            PCL_INSTANTIATE_IntrinsicSymmetryEstimation(pcl::PointXYZRGBNormal)
