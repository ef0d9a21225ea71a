/** \file
 * \brief The points that a surface is prepared from: what cannot be used is left out, clouds are cleaned and thinned
 * out.
 */
#pragma once

#include "cloud/resampled_cloud.h"
#include "geodesic/neighbour_graph.h"
#include "symmetry/surface/usable_points.h"

#include <pcl/symmetry/symmetry_parameters.h>

namespace pcl {
namespace symmetry {

/** \brief What the faces of a mesh are used for: how its points hang together, or only where they face. A mesh with
 * holes is in pieces where as a cloud it would be bridged. */
enum class FaceUse : char { Connection, Normals };

/** \brief The points of a cloud at unit scale, without what is not finite, repeated or far away, and their neighbours. */
UsablePoints
distinctPoints(const Surface& cloud, const SymmetryParameters& parameters, const NeighbourSearch& search);

/** \brief Drops what cannot be used and normalises the rest; goes over to the resampled points of a cloud.
 * \param[in] surface the input; triangle indices must be in range
 * \param[in] search nearest-neighbour search; used for clouds only
 * \param[in] interpretation see resampleCloud ()
 * \param[in] faces Normals: the vertices of a mesh become a cloud; those of no face are left out
 * \param[in] points that a mesh should have at least, see splitLongSides (); 0: it stays as it is
 */
UsablePoints
usablePoints(const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             NoiseInterpretation interpretation = NoiseInterpretation::Smooth,
             FaceUse faces = FaceUse::Connection,
             std::size_t points = 0);

} // namespace symmetry
} // namespace pcl
