/** \file
 * \brief Side of every sample, by the votes of matched pairs whose order is unknown at first.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/search/functional_map.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Pairs of landmarks far apart, each ordered so that all first ones lie on one side of the axis. */
struct OrderedPairs {
  std::vector<Index> sources; ///< landmarks
  std::vector<Index> targets; ///< their partners
};

/** \brief Takes the pairs that the map moves farthest and orders them consistently.
 *
 * Two pairs agree when most landmarks that are nearer to the first end of one are nearer to the first end of the other.
 * The order is the sign of the leading eigenvector of the matrix of agreements. \param[in] map partner of every
 * landmark
 */
OrderedPairs
orderPairs(const LandmarkSurface& landmarks, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
