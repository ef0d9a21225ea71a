/** \file
 * \brief Links between the parts of an object that touch, overlap or lie close.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is one object although its surface is in parts. */
struct LinkedParts {
  std::vector<GraphEdge> links; ///< from points of one part to the nearest of another
  std::vector<Index> group_of;  ///< per part: the lowest part that it hangs together with, itself perhaps
};

/** \brief How far parts that belong together may be apart. */
enum class PartGaps : char { Narrow, Any };

/** \brief Links parts of a surface.
 *
 * Parts that come as near to each other as their points lie apart touch or overlap: all such pairs of points are linked,
 * so that the way from one part to the other leads through where they meet. What is still apart is linked to the
 * nearest other parts, in rounds as in Boruvka's minimum spanning tree, across gaps that are narrow next to the smaller
 * side: half of its size, or three times as wide as its own points lie apart. What lies farther away belongs to something
 * else, unless any gap is to be bridged.
 *
 * \param[in] points at unit scale
 * \param[in] parts of the graph over the points
 * \param[in] spacings of each part: typical distance of neighbouring points
 */
LinkedParts
linkParts(const std::vector<Vector3>& points,
          const Components& parts,
          const std::vector<float>& spacings,
          PartGaps gaps);

} // namespace symmetry
} // namespace pcl
