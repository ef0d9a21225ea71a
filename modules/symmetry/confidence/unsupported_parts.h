/** \file
 * \brief The parts of a surface that a partial map leaves out, one by one.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Describes the connected groups of unsupported points, the largest first; indices and lengths are those of the
 * prepared surface. Cost: one shortest-path search.
 * \param[in] is_unsupported one entry per point */
std::vector<UnsupportedPart>
unsupportedParts(const PreparedSurface& surface, const std::vector<char>& is_unsupported);

/** \brief Takes the mark off connected groups of less than a share of the area. */
void
dropSmallParts(const PreparedSurface& surface, float least_share, std::vector<char>& is_unsupported);

/** \brief Share of the area (where there are no triangles: of the points) that has a partner.
 * \param[in] partners one per point, no_index where there is none */
float
shareWithPartner(const PreparedSurface& surface, const std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
