/** \file
 * \brief Extreme points of a surface, and the functions whose maxima they and other extremities are (paper,
 * section 3.1).
 */
#pragma once

#include "geodesic/surface_graph.h"
#include "symmetry/staged/spectral_embedding.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The surface's graph with its edges as long as they are in the embedding: what bending has done to the surface
 * is smoothed away in it. */
SurfaceGraph
embeddedGraph(const SurfaceGraph& graph, const SpectralEmbedding& embedding);

/** \brief Vertices geodesically farthest from each other: farthest-point sampling, then each in turn moved to where the
 * others are farthest until none moves.
 *
 * \param[in] start any vertex; the first sample is the one farthest from it
 * \return fewer than \a count where the surface has no more distinct ones
 */
std::vector<Index>
mutuallyFarthestVertices(const SurfaceGraph& graph, Index start, std::size_t count);

/** \brief Average and minimal geodesic distances on the embedded surface and their local maxima. */
struct ExtremityFunctions {
  std::vector<float> average;        ///< AGD: mean distance to evenly spaced samples, smoothed over 1-rings
  std::vector<Index> average_maxima; ///< S1: extremities of whatever sticks out
  std::vector<float> minimal;        ///< MGD: distance to the nearest vertex of S1
  std::vector<Index> minimal_maxima; ///< S2: what lies between the extremities
};

/** \brief AGD, S1, MGD and S2 (the paper's names).
 *
 * Local maxima of the average geodesic distance \cite hilaga2001topology are found by every symmetry, and so are those
 * of the distance to them \cite kim2010moebius.
 *
 * A fine mesh has dozens of maxima on one fingertip; of those closer together than \a separation only the largest
 * counts, so that the few matches that are kept later are not all at one place.
 *
 * \param[in] embedded see embeddedGraph
 * ()
 *
 * \param[in] start first of the samples
 *
 * \param[in] samples how many; the paper: 100
 *
 * \param[in] separation least
 * distance of two maxima
 */
ExtremityFunctions
extremityFunctions(const SurfaceGraph& embedded, Index start, std::size_t samples, float separation);

} // namespace symmetry
} // namespace pcl
