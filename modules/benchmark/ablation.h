/** \file
 * \brief What each ingredient of the robust method contributes: the accuracy without it.
 */
#pragma once

#include "benchmark/run.h"
#include "symmetry/robust_method.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The robust method with one ingredient changed. */
struct Ablation {
  std::string name;
  RobustSettings settings;
};

/** \brief The whole method first, then one change each. */
std::vector<Ablation>
ablations();

/** \brief Runs every ablation on the first interpretation of every model, \a jobs at a time: what other interpretations
 * repair is not repaired. The map is scored whether it would be delivered or not.
 * \return per ablation, in the order of ablations (), the runs of all models; a failure is part of its run */
std::vector<std::vector<ModelRun>>
runAblations(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs);

/** \brief A line for each ablation: rate and Mesh Rate of each set and the median of the times over those of the whole
 * method.
 * \param[in] runs as runAblations () returns them */
void
printAblations(std::ostream& out, const std::vector<std::vector<ModelRun>>& runs);

} // namespace symmetry
} // namespace pcl
