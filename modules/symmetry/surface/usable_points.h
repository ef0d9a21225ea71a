/** \file
 * \brief What is left of the input when it is cleaned.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What does not depend on how the contacts of a cloud are read. */
struct UsablePoints {
  PreparedSurface
      surface; ///< without graph; of a cloud also without triangles, and with normals only where they are given
  NeighbourLists neighbours;     ///< of a cloud
  std::vector<char> is_oriented; ///< see ResampledCloud; where empty, normals are oriented all or there are none
};

} // namespace symmetry
} // namespace pcl
