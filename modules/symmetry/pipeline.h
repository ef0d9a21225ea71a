/** \file
 * \brief The whole sequence, from a surface to the result, on one screen.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "symmetry/rival_interpretations.h"
#include "symmetry/step_timer.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <functional>

namespace pcl {
namespace symmetry {

/** \brief Understands a surface in one way after another until its symmetry is settled, and returns the way that
 * convinces most, with the map.
 * \param[out] summary what was used, also if the timer cancels
 * \param[in] observer is shown each interpretation with its map, also one that is refused; may be empty
 * \throws Cancelled by the timer */
Interpretation
interpretSurface(const Surface& surface,
                 const SymmetryParameters& parameters,
                 const NeighbourSearch& search,
                 StepTimer& timer,
                 InputSummary& summary,
                 const std::function<void(const Interpretation&)>& observer = {});

/** \brief Estimates the symmetry of a surface whose triangles and parameters have been checked.
 *
 * \param[in] surface triangle indices in range
 * \param[in] parameters all within their ranges
 * \param[in] search nearest-neighbour search for clouds
 * \param[in] timer tells the caller of each step
 */
SymmetryResult
runPipeline(const Surface& surface,
            const SymmetryParameters& parameters,
            const NeighbourSearch& search,
            StepTimer& timer);

} // namespace symmetry
} // namespace pcl
