/** \file
 * \brief The published method: staged coarse-to-fine matching from four extreme points.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/step_timer.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

namespace pcl {
namespace symmetry {

/** \brief Finds the symmetric map of a surface that has two pairs of limbs.
 *
 * Every step is that of the paper; where it departs from it the step says so and why. Status TooFewPoints below 20
 * points, NoSymmetry where the surface has fewer than four distinct extreme points, no pair of limbs can be matched or
 * the confidence is below minimum_trusted_confidence.
 * \param[in] surface connected, at unit scale
 * \param[in] parameters metric, staged, sparse_only
 * \param[in,out] timer told of the steps sampling, geodesics, embedding, hypotheses, matching, dense
 * \throws Cancelled by the timer
 */
MapEstimate
estimateStaged(const PreparedSurface& surface, const SymmetryParameters& parameters, StepTimer& timer);

} // namespace symmetry
} // namespace pcl
