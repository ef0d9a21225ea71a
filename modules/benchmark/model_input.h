/** \file
 * \brief A model of a data set as it is given to the estimation, and what is asked of it.
 */
#pragma once

#include "benchmark/run.h"
#include "symmetry/surface/prepared_surface.h"

namespace pcl {
namespace symmetry {

/** \brief A model, read, varied and disturbed. */
struct ModelInput {
  Surface mesh;                 ///< as in the file; maps are scored on it
  DisturbedSurface input;       ///< what the estimation gets
  std::vector<Index> stand_ins; ///< of a variant, see VariedSurface; else empty
  GroundTruth asked; ///< what is scored; empty without ground truth; after a limb was cut off the pairs that are left
};

/** \brief What is known of a vertex of the file. */
enum class VertexTruth : char {
  Unknown, ///< it is not left, or its partner is not known
  Paired,  ///< its true partner is left as well
  Odd      ///< its true partner is cut off
};

/** \brief The same of all vertices. */
std::vector<VertexTruth>
vertexTruths(const BenchmarkModel& model, const ModelInput& input);

/** \brief Takes what was estimated per point of the input, a map, back to the points of the file. */
std::vector<Index>
mapOfFile(const ModelInput& input, const std::vector<Index>& partners);

/** \brief Reads a model and its ground truth and disturbs it.
 * \throws as readSurface (), readGroundTruth (), cutLimb () and disturb () */
ModelInput
readModel(const BenchmarkModel& model, const RunOptions& options);

/** \brief What the estimation gets, as its first interpretation has it. */
PreparedSurface
firstSurface(const ModelInput& input, const SymmetryParameters& parameters);

/** \brief The parameters of the estimation: those of the options, but for a variant with another number of samples. */
SymmetryParameters
parametersFor(const BenchmarkModel& model, const RunOptions& options);

} // namespace symmetry
} // namespace pcl
