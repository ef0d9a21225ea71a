/** \file
 * \brief The way down to the vertex of a graph where some cost is least around.
 */
#pragma once

#include "geodesic/surface_graph.h"

namespace pcl {
namespace symmetry {

/** \brief Goes on to the neighbour of least cost as long as that is less than here; ties go to the lower vertex.
 * \param[in] cost called with a vertex; finite */
template <typename Cost>
Index
walkDown(const SurfaceGraph& graph, Index start, const Cost& cost)
{
  Index here = start;
  float least = cost(here);
  for (bool moved = true; moved;) {
    moved = false;
    const Index from = here;
    for (const Index w : graph.neighboursOf(from)) {
      const float there = cost(w);
      if (there < least) {
        least = there;
        here = w;
        moved = true;
      }
    }
  }
  return here;
}

} // namespace symmetry
} // namespace pcl
