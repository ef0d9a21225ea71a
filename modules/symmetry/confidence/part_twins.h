/** \file
 * \brief Whether a map pairs the parts of an object with parts like them.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Share of the area of an object in several parts that goes to a twin: each part counts by the share of it that
 * goes to the part most of it goes to, times how alike the two are: the smaller over the larger of their areas and of
 * their spreads (square root of the trace of the second moments about their centroids), neither of which bending a limb
 * or turning a part changes much. 1 where there is one part.
 *
 * Distances across many links tell little of a map; a drawer that is sent to a leg tells all.
 * \param[in] partners one per point, -1 where there is none: what goes nowhere does not go to a twin */
float
shareOfTwinParts(const PreparedSurface& surface, const std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
