/** \file
 * \brief From the points that can be used to the surface that every method starts from.
 */
#pragma once

#include "cloud/cloud_surface.h"
#include "geodesic/neighbour_graph.h"
#include "symmetry/surface/input_cleaning.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

namespace pcl {
namespace symmetry {

/** \brief Builds the graph and restricts the surface to its largest component.
 * \param[in] contact how readily edges of a cloud are taken for shortcuts
 */
PreparedSurface
prepareSurface(UsablePoints usable, const SymmetryParameters& parameters, const ContactTest& contact);

/** \brief A cloud as it stands: all points but the far ones, with edges to the nearest neighbours whatever they touch,
 * and normals up to sign. Enough to see whether it is its own mirror image in space. */
PreparedSurface
prepareAsItStands(const Surface& cloud, const SymmetryParameters& parameters, const NeighbourSearch& search);

/** \brief Both steps at once. */
PreparedSurface
prepareSurface(const Surface& surface,
               const SymmetryParameters& parameters,
               const NeighbourSearch& search,
               const ContactTest& contact = {});

} // namespace symmetry
} // namespace pcl
