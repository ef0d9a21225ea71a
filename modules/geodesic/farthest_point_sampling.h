/** \file
 * \brief Evenly spaced samples of a surface and their Voronoi cells.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Samples, and for every vertex the nearest one. */
struct FarthestPointSamples {
  std::vector<Index> vertices; ///< in the order found; each is the vertex farthest from all before it
  std::vector<float> radii;    ///< distance of each sample from those before it, when it was found; the first: infinity
  std::vector<Index> owner;    ///< per vertex: number (in \a vertices) of the nearest sample; -1 where none reaches
  std::vector<float> distance; ///< per vertex: distance to that sample
};

/** \brief Farthest-point sampling \cite gonzalez1985clustering \cite eldar1997farthest from an explicit start.
 *
 * Ties go to the lowest vertex. Ends early where every vertex is a sample or at distance zero from one. A new sample's
 * search is cut where an earlier sample is nearer, so that all searches together cost about as much as a few full
 * distance fields.
 * \param[in] graph connected, or the samples stay in the start's component
 * \param[in] start first sample
 * \param[in] count number of samples wanted
 */
FarthestPointSamples
farthestPointSampling(const SurfaceGraph& graph, Index start, std::size_t count);

} // namespace symmetry
} // namespace pcl
