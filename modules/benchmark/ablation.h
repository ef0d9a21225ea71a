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

/** \brief How one ablation did on one model. */
struct AblationRun {
  BenchmarkModel model;
  double rate = 0.0;    ///< Correspondence Rate of the map, delivered or not; 0 without one
  double seconds = 0.0; ///< of the estimation on the prepared surface
};

/** \brief Runs every ablation on the first interpretation of every model, \a jobs at a time: what other interpretations
 * repair is not repaired. Models that fail are left out with a line to \a errors.
 * \return per ablation, in the order of ablations (), a run for every model */
std::vector<std::vector<AblationRun>>
runAblations(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs, std::ostream& errors);

/** \brief A line for each ablation: rate and Mesh Rate of each set (means over its classes) and time over that of the
 * whole method. */
void
printAblations(std::ostream& out, const std::vector<std::vector<AblationRun>>& runs);

} // namespace symmetry
} // namespace pcl
