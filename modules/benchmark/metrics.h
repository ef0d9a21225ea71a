/** \file
 * \brief Scores a symmetric map against ground truth: Correspondence Rate, Mesh Rate and Geodesic Error.
 *
 * The error of a vertex is the geodesic distance, along the edges of the mesh, from its computed to its true
 * partner. The metrics are those of Kim, Lipman, Chen and Funkhouser: Moebius transformations for global intrinsic
 * symmetry analysis, 2010, and Blended intrinsic maps, 2011. \cite kim2010moebius \cite kim2011blended
 */
#pragma once

#include "benchmark/ground_truth.h"

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A map is right when its Correspondence Rate exceeds this. */
constexpr double right_map_rate = 0.75;

/** \brief How far one vertex with known partner is off. */
struct VertexError {
  Index vertex = no_index;
  double geodesic = 0.0; ///< share of the diameter, in [0, 1]; 1 where the vertex has no partner
  bool right = false;    ///< the distance is below MapAccuracy::radius
};

/** \brief The score of one map. */
struct MapAccuracy {
  std::size_t vertices = 0;        ///< of the mesh
  std::size_t matched = 0;         ///< scored vertices that have a partner
  std::size_t map_size = 0;        ///< vertices that have a partner
  double area = 0.0;               ///< of the mesh, squared unit of the points
  double radius = 0.0;             ///< sqrt(area / (20 pi)), unit of the points
  double diameter = 0.0;           ///< largest geodesic distance, unit of the points
  std::vector<VertexError> errors; ///< one per scored vertex, in the order of the ground truth

  /** \brief Share of the scored vertices that are right. */
  double
  correspondenceRate() const;

  /** \brief Mean Geodesic Error, share of the diameter. */
  double
  meanGeodesicError() const;

  /** \brief Share of the scored vertices with a Geodesic Error below \a threshold (share of the diameter). */
  double
  shareBelow(double threshold) const;

  /** \brief Mesh Rate of this one mesh: its Correspondence Rate exceeds right_map_rate. */
  bool
  isRight() const
  {
    return correspondenceRate() > right_map_rate;
  }
};

/** \brief Every k-th entry of a ground truth with more than 200, k chosen so that at most 200 are left. */
GroundTruth
subsampleTruth(const GroundTruth& truth);

/** \brief Scores \a partners on \a mesh.
 *
 * The diameter is what four sweeps find, each from the vertex farthest from the one before, beginning at the first
 * vertex of \a truth. Cost: one shortest-path field per scored vertex, at most 200 (see subsampleTruth()).
 * \param[in] mesh surface with faces; distances are measured along its edges
 * \param[in] truth not empty
 * \param[in] partners one per point of the mesh, no_index: none, which counts as wrong
 * \throws pcl::BadArgumentException no faces, no truth, another number of partners than points, an index out of range,
 * or a mesh without extent
 */
MapAccuracy
scoreMap(const Surface& mesh, const GroundTruth& truth, const std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
