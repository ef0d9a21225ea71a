/** \file
 * \brief Extremities in symmetric pairs and the regions around them, from a map of the hubs.
 */
#pragma once

#include "symmetry/hub_surface.h"
#include "symmetry/pair_votes.h"

#include <pcl/symmetry/symmetry_result.h>

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The two pairs of swapped extremities that are farthest apart, source side first; fewer where the surface has
 * fewer. */
std::vector<std::pair<Index, Index>>
swappedExtremities(const HubSurface& hubs, const SampleMap& map, const OrderedPairs& pairs);

/** \brief Region of every hub: limb of a pair where the hub is nearer to its end than half the way to the other end,
 * else centre (as the regions of the staged method). */
std::vector<Region>
hubRegions(const HubSurface& hubs, const std::vector<std::pair<Index, Index>>& limbs);

} // namespace symmetry
} // namespace pcl
