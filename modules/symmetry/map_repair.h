/** \file
 * \brief Local repair of a map that is a reflection on most of a surface, but not on all of it.
 */
#pragma once

#include "symmetry/functional_map.h"
#include "symmetry/hub_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How far the map turns the surface over around every hub: -1 nowhere (as a rotation), 1 everywhere.
 *
 * Mean over the triangles within two steps of the hub, by area; an image counts by its own area, at most by that of the
 * original. 0 where no triangle is mapped.
 */
std::vector<float>
reversalAtHubs(const HubSurface& hubs, const SampleMap& map);

/** \brief Derives a map anew wherever it does not reverse the orientation.
 *
 * A part behind a thin neck (a head) is hardly seen by the lowest eigenfunctions, so that a map may leave it as it is
 * or turn it. From the sound surroundings hub after hub is placed, neighbours first, where its distances to the hubs
 * placed around it come out best, then all placed hubs are relaxed in the same way.
 * \return empty where all of the map is sound or most of it is not
 */
SampleMap
repairedMap(const HubSurface& hubs, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
