/** \file
 * \brief From a surface with a result to what names are compared by.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "symmetry/names/comparable_surface.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Prepares and samples the points of a surface that have partners.
 * \param[in] sides one per point
 * \param[in] partners one per point; -1: none
 * \param[in] search of the neighbours of a cloud
 * \return not comparable where there are too few points */
ComparableSurface
describeLabelled(const Surface& surface,
                 const std::vector<Side>& sides,
                 const std::vector<Index>& partners,
                 const NeighbourSearch& search);

} // namespace symmetry
} // namespace pcl
