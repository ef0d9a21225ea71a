/** \file
 * \brief What a picture of a cloud without faces needs: point spacing and normals, roughly.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

struct CloudShading {
  std::vector<float> spacings;  ///< mean distance of neighbours around each point
  std::vector<Vector3> normals; ///< one per point, of either sign; zero where there is none
};

/** \brief Estimates both from the cells of a grid, in linear time. Good enough to look at, not to compute with. */
CloudShading
estimateCloudShading(const std::vector<Vector3>& points);

} // namespace symmetry
} // namespace pcl
