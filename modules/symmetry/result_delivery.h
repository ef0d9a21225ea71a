/** \file
 * \brief From what a method hands on to the result: in numbers and units of the input.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

namespace pcl {
namespace symmetry {

/** \brief A result that says nothing about any point. */
SymmetryResult
emptyResult(const Surface& surface);

/** \brief Takes the parts without a counterpart, and what is sent there, out of a partial map. */
void
leaveOutUnsupported(MapEstimate& estimate);

/** \brief Fills in partners, sides, axis, matches, limbs and, of a partial map, the parts that are left out.
 * \param[in] parameters sparse_only: no dense map; label_axis
 * \param[in,out] result with the measures of the map and one entry per point of the input in every array */
void
deliverResult(const MapEstimate& estimate,
              const PreparedSurface& prepared,
              const SymmetryParameters& parameters,
              SymmetryResult& result);

} // namespace symmetry
} // namespace pcl
