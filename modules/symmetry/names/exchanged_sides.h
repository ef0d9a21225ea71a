/** \file
 * \brief Source for target and target for source.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

namespace pcl {
namespace symmetry {

/** \brief Calls the source side target and the target side source, wherever a result speaks of them. */
void
exchangeSides(SymmetryResult& result);

} // namespace symmetry
} // namespace pcl
