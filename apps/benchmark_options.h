/** \file
 * \brief Command line of pcl_symmetry_benchmark.
 */
#pragma once

#include "benchmark/run.h"
#include "cli/command_line.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is asked for. */
struct BenchmarkOptions {
  std::string folder;
  std::vector<std::string> sets;
  std::vector<std::string> classes;
  bool all = false;
  bool graph = false;
  bool ablation = false;
  bool names = false;
  std::vector<std::string> exchanged;
  std::string evidence;
  std::string vertex_evidence;
  bool contenders = false; ///< evidence of those of the first interpretation
  RunOptions run;
  int samples = 0; ///< of the method that runs; 0: its default
  unsigned jobs = 1;
  std::optional<unsigned> threads;
  unsigned holes = 0;
  unsigned variants = 0;
  std::int64_t seed = 1;
  std::string map_folder;
  std::string csv;
  std::string json;
  std::string plot;
  std::string paper;
  bool verbose = false;

  std::string scored_map; ///< not empty: score this map of score_mesh instead of running anything
  std::string score_mesh;
  std::string score_truth;

  std::vector<std::string>
  outputs() const
  {
    return {csv, json, plot, evidence, vertex_evidence};
  }
};

/** \brief The options, which write to \a options. */
CommandLine
describeOptions(BenchmarkOptions& options);

/** \brief What follows from several options, or from the words beside them.
 * \throws UsageError a value is out of its range, or two do not go together */
void
completeOptions(BenchmarkOptions& options, const CommandLine& line);

} // namespace symmetry
} // namespace pcl
