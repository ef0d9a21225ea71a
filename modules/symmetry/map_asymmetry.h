/** \file
 * \brief Signs that a surface is no mirror image of itself in spite of a map that looks like a reflection.
 */
#pragma once

#include "symmetry/functional_map.h"
#include "symmetry/hub_surface.h"

namespace pcl {
namespace symmetry {

/** \brief Where one side has a part that the other lacks, a map is bad in one place and good everywhere else, so it is
 * the worst hundredth of the hubs that is looked at; means hardly notice. */
struct AsymmetrySigns {
  float concentration = 1.0F; ///< stretch of the map at the worst hundredth of the hubs over the median stretch
  float change = 1.0F;     ///< after tears are healed: mean change of the distances to all hubs, at the worst hundredth
  float involution = 1.0F; ///< after tears are healed: d (i, m (m (i))), at the worst hundredth
};

/** \brief Lengths are shares of the diameter. */
AsymmetrySigns
findAsymmetry(const HubSurface& hubs, const SampleMap& map);

/** \brief One number from all signs: log of a product of powers, the larger the less symmetric.
 * \param[in] curvature as in MapScore */
float
asymmetry(const AsymmetrySigns& signs, float curvature);

} // namespace symmetry
} // namespace pcl
