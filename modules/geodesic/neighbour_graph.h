/** \file
 * \brief Graph of a point cloud without faces, from the k nearest neighbours of each point.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Result of a nearest-neighbour search over a cloud: neighbours of point i are entries [i * k, (i + 1) * k),
 * nearest first; -1 where fewer were found. The point itself may be among them or not. */
struct NeighbourLists {
  std::size_t k = 0;
  std::vector<Index> neighbours;

  /** \brief The neighbours that were found of one point, perhaps itself among them. */
  IndexRange
  of(std::size_t v) const
  {
    const Index* const first = neighbours.data() + v * k;
    return {first, std::find(first, first + k, no_index)};
  }
};

/** \brief Searches the k nearest neighbours of every point, each on any thread. */
using NeighbourSearch = std::function<NeighbourLists(const std::vector<Vector3>& points, int k)>;

/** \brief Plain k-nearest-neighbour graph: an edge wherever either point has the other among its neighbours, of
 * Euclidean length. Self-loops are dropped, duplicates of a point are linked by edges of length zero.
 *
 * \param[in] radius
 * longest edge, 0: no limit */
SurfaceGraph
buildNeighbourGraph(const std::vector<Vector3>& points, const NeighbourLists& lists, float radius);

} // namespace symmetry
} // namespace pcl
