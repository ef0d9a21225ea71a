/** \file
 * \brief Spectral embedding of a surface from the distances to its landmarks (paper, section 3.1).
 */
#pragma once

#include "geodesic/shortest_paths.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Coordinates whose Euclidean distances resemble the geodesic distances of the surface. */
struct SpectralEmbedding {
  int dimensions = 0;
  std::vector<float> coordinates; ///< vertex v has entries [v * dimensions, (v + 1) * dimensions)
  std::vector<float> eigenvalues; ///< per dimension, falling: the squared extent of the landmarks along it

  const float*
  at(std::size_t v) const
  {
    return coordinates.data() + v * static_cast<std::size_t>(dimensions);
  }
};

/** \brief Landmark multidimensional scaling: classical scaling of the landmarks (squared distances, double-centred),
 * all other vertices by distance-based triangulation.
 *
 * V. de Silva, J. Tenenbaum: Sparse multidimensional scaling using landmark points. Stanford, 2004.
 * \cite silva2004landmarks
 * \param[in] fields distance fields of the landmarks, row i that of landmarks[i]
 * \param[in] landmarks their vertices
 * \param[in] dimensions number of coordinates; fewer are returned where fewer eigenvalues are positive
 */
SpectralEmbedding
embedByLandmarks(const DistanceFields& fields, const std::vector<Index>& landmarks, int dimensions);

} // namespace symmetry
} // namespace pcl
