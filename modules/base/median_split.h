/** \file
 * \brief The step that trees over points are built of: half of them to each side.
 */
#pragma once

#include "base/bounding_box.h"
#include "base/vector_math.h"

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Orders a range of point numbers so that those before its middle lie on one side along the longest side of a box.
 *
 * What lies equally far is ordered by number: the same points, the same tree.
 * \param[in] box of these points
 * \return the middle */
inline std::uint32_t
splitAtMedian(const std::vector<Vector3>& points,
              const BoundingBox& box,
              std::uint32_t begin,
              std::uint32_t end,
              std::vector<Index>& numbers)
{
  const Vector3 sides = box.high - box.low;
  const auto axis = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(numbers.begin() + begin, numbers.begin() + middle, numbers.begin() + end, [&](Index a, Index b) {
    return points[a][axis] < points[b][axis] || (points[a][axis] == points[b][axis] && a < b);
  });
  return middle;
}

} // namespace symmetry
} // namespace pcl
