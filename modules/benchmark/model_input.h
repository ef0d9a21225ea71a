/** \file
 * \brief A model of a data set as it is given to the estimation, and what is asked of it.
 */
#pragma once

#include "benchmark/run.h"

namespace pcl {
namespace symmetry {

/** \brief A model, read and disturbed. */
struct ModelInput {
  Surface mesh;           ///< as in the file; maps are scored on it
  DisturbedSurface input; ///< what the estimation gets
  GroundTruth asked; ///< what is scored; empty without ground truth; after a limb was cut off the pairs that are left
};

/** \brief Reads a model and its ground truth and disturbs it.
 * \throws as readSurface (), readGroundTruth (), cutLimb () and disturb () */
ModelInput
readModel(const BenchmarkModel& model, const RunOptions& options);

} // namespace symmetry
} // namespace pcl
