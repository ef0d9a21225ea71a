/** \file
 * \brief Signs that a surface is no mirror image of itself in spite of a map that looks like a reflection.
 */
#pragma once

#include "symmetry/functional_map.h"
#include "symmetry/hub_surface.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief Where one side has a part that the other lacks, a map stretches the surface in one place and keeps it
 * everywhere else, so it is the worst places that are looked at; means hardly notice. */
struct AsymmetrySigns {
  float concentration = 1.0F; ///< stretch of the map at the worst hundredth of the hubs over the median stretch
  /** Change of the distances around a hub, as a share of those distances, at the worst 3 % of the hubs; after the map
   * has been relaxed: what a better map would not stretch does not count. */
  float stretch = 1.0F;
  float involution = 1.0F; ///< mean d (i, m (m (i))) of the relaxed map, share of the diameter
  /** Change of the average distance to all hubs from a hub to its image, share of the diameter, at the worst 3 % of the
   * hubs: what a pose changes in the large. */
  float centrality = 1.0F;
  float curvature = 2.0F; ///< mean squared difference of curvature around a hub over its variance: the median hub
};

/** \brief Cost: about that of scoring a few maps of all hubs.
 * \param[in] curvature ShapeDescriptor::curvature; row i belongs to hub i, further rows do not count */
AsymmetrySigns
findAsymmetry(const HubSurface& hubs, const Eigen::MatrixXf& curvature, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
