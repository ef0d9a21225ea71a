/** \file
 * \brief How badly the patches of a map fit, in one number by which maps of one surface are compared.
 */
#pragma once

#include "symmetry/refine/patch_alignment.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Logarithm of the misfit of the patches: of the root of their distance, and of their turn twice, by its mean and
 * by its median.
 *
 * Normals tell more than distances: on a smooth body a wrong patch lies close as well, but does not face the right way.
 * The mean is that of the worst places, a contact or a hand, which a right map has as well; the median says how well
 * the map fits where nothing disturbs it.
 * \param[in] fits at least one
 * \param[in] mean of them, see meanOf ()
 * \param[in] weight_of_median of the turn, beside that of the mean */
float
logMisfit(const std::vector<PatchFit>& fits, const PatchFit& mean, float weight_of_median);

} // namespace symmetry
} // namespace pcl
