/** \file
 * \brief The four limb regions around the extreme points and the fifth, central one (paper, section 3.2).
 */
#pragma once

#include "geodesic/shortest_paths.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Region of every vertex: source 1 are those closer to h1 than the midpoint m_h of h1 and h2 is, target 1 the
 * same with h2; source 2 and target 2 with f1, f2 and m_f; the centre is the rest.
 *
 * Where two regions overlap the one whose extreme point is relatively closer (distance / radius of the region) wins.
 * \param[in] source_fields distance fields of h1 and f1, in this order
 * \param[in] target_fields distance fields of h2 and f2
 * \param[in] m_h midpoint of h1 and h2
 * \param[in] m_f midpoint of f1 and f2
 */
std::vector<Region>
limbRegions(const DistanceFields& source_fields, const DistanceFields& target_fields, Index m_h, Index m_f);

} // namespace symmetry
} // namespace pcl
