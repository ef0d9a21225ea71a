/** \file
 * \brief Whether a result belongs to a surface.
 */
#pragma once

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

namespace pcl {
namespace symmetry {

/** \brief Checks that each per-point array has one entry per point, that confidences and support are numbers, sides and regions among those that there are, and that partners, matches and axis refer to points.
 * \throws pcl::BadArgumentException says which does not
 */
void
checkResult(const SymmetryResult& result, std::size_t points);

} // namespace symmetry
} // namespace pcl
