/** \file
 * \brief Samples that stand for a surface.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Evenly spread samples of a surface that stand for their surroundings; arrays have one entry each. */
struct AreaSamples {
  std::vector<Vector3> points; ///< the first ones spread over the whole surface, as farthest points do
  std::vector<Vector3> normals;
  std::vector<float> areas; ///< they sum up to 1

  std::size_t
  size() const
  {
    return points.size();
  }
};

} // namespace symmetry
} // namespace pcl
