/** \file
 * \brief Side of every sample, by the votes of matched pairs whose order is unknown at first.
 */
#pragma once

#include "symmetry/functional_map.h"
#include "symmetry/hub_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Pairs of hubs far apart, each ordered so that all first ones lie on one side of the axis. */
struct OrderedPairs {
  std::vector<Index> sources; ///< hubs
  std::vector<Index> targets; ///< their partners
};

/** \brief Takes the pairs that the map moves farthest and orders them consistently.
 *
 * Two pairs agree when most hubs that are nearer to the first end of one are nearer to the first end of the other. The
 * order is the sign of the leading eigenvector of the matrix of agreements.
 * \param[in] map partner of every hub
 */
OrderedPairs
orderPairs(const HubSurface& hubs, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
