/** \file
 * \brief Points of a cloud that are none of the surface, and the cloud that stands for a noisy or huge one.
 */
#pragma once

#include "cloud/resampled_cloud.h"
#include "geodesic/neighbour_graph.h"
#include "symmetry/surface/usable_points.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Drops points that are so far from the middle of all that no surface reaches there: at unit scale they would
 * leave few bits for all others. */
void
dropFarOutliers(PreparedSurface& surface);

/** \brief Leaves out the parts of a cloud that are farther from the largest one than this is long, another body or
 * single points, and scales what is left anew: all tolerances are relative to it.
 * \param[in] input where the points come from, with the digits that they have lost at the scale of all
 * \param[in,out] surface a cloud at unit scale */
void
dropFarParts(const std::vector<Vector3>& input,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             PreparedSurface& surface);

/** \brief Statistical outlier removal (R. Rusu et al., 2008 \cite rusu2008cloud): drops the points whose mean distance
 * to their neighbours exceeds the mean of the cloud by more than SymmetryParameters::outlier_deviations standard
 * deviations. */
void
dropStatisticalOutliers(PreparedSurface& surface, const SymmetryParameters& parameters, const NeighbourSearch& search);

/** \brief Goes over to a cloud without outliers and noise, of a size that is solved in a moment, and finds the
 * neighbours of its points. */
void
resample(UsablePoints& usable,
         const SymmetryParameters& parameters,
         const NeighbourSearch& search,
         NoiseInterpretation interpretation);

/** \brief Gives the points without a normal the one of the plane through their neighbours, to be turned as those
 * around. */
void
completeNormals(UsablePoints& usable);

} // namespace symmetry
} // namespace pcl
