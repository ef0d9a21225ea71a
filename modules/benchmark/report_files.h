/** \file
 * \brief The figures of a benchmark as files for programs.
 */
#pragma once

#include "benchmark/run.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Writes one line per model: what it is, its score, its seconds per step.
 *
 * As every writer here: the file appears whole or not at all (it is written beside its place and then renamed).
 * \throws pcl::IOException cannot be written
 */
void
writeCsvReport(const std::string& path, const std::vector<ModelRun>& runs);

/** \brief Writes one object: `parameters`, `models`, `classes`, `sets`, `curves` and `confidence`.
 * \throws pcl::IOException cannot be written */
void
writeJsonReport(const std::string& path, const std::vector<ModelRun>& runs, const RunOptions& options);

/** \brief Writes the score of one map as one object, with the names that the CSV report has.
 * \throws pcl::IOException cannot be written */
void
writeJsonScore(const std::string& path, const MapAccuracy& score);

} // namespace symmetry
} // namespace pcl
