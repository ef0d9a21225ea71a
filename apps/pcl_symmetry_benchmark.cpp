/** \file
 * \brief pcl_symmetry_benchmark: runs the estimation on published data sets and prints the field's metrics.
 */
#include "base/thread_scope.h"
#include "benchmark/ablation.h"
#include "benchmark/error_curve_plot.h"
#include "benchmark/evidence.h"
#include "benchmark/graph_accuracy.h"
#include "benchmark/map_file.h"
#include "benchmark/name_consistency.h"
#include "benchmark/paper_report.h"
#include "benchmark/report_files.h"
#include "benchmark/report_table.h"
#include "benchmark/run.h"
#include "benchmark_options.h"
#include "cli/command_line.h"
#include "cli/output_names.h"

#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

using namespace pcl::symmetry;

namespace {

bool
isSelected(const std::vector<std::string>& wanted, const std::string& name)
{
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

std::vector<BenchmarkModel>
selectModels(const BenchmarkOptions& options)
{
  std::vector<BenchmarkModel> selected;
  std::size_t without_truth = 0;
  for (BenchmarkModel& model : findModels(options.folder)) {
    if (!isSelected(options.sets, model.set) || !isSelected(options.classes, model.class_name))
      continue;
    if (model.truth.empty() && !options.all)
      ++without_truth;
    else
      selected.push_back(std::move(model));
  }
  addVariants(selected, options.variants);
  if (without_truth > 0)
    std::cerr << without_truth << " models without ground truth are left out (--all runs them)\n";
  if (selected.empty())
    throw pcl::IOException(options.folder + ": no model is left to run");
  return selected;
}

void
writeRunMap(const std::string& folder, const ModelRun& run)
{
  SymmetryResult result;
  result.partners = run.partners;
  result.confidences = run.confidences;
  result.support.resize(run.points, 0.0F);
  result.sides.resize(run.points, Side::None);
  result.regions.resize(run.points, Region::None);
  writeMap((std::filesystem::path(folder) / (run.model.set + "_" + run.model.name + ".csv")).string(), result);
}

void
writeReports(const BenchmarkOptions& options, const std::vector<ModelRun>& runs)
{
  if (!options.csv.empty())
    writeCsvReport(options.csv, runs);
  if (!options.json.empty())
    writeJsonReport(options.json, runs, options.run);
  if (!options.plot.empty())
    writeErrorCurves(options.plot, errorCurves(runs));
}

int
scoreExistingMap(const BenchmarkOptions& options)
{
  checkDistinct(options.outputs(), {options.scored_map, options.score_mesh, options.score_truth});
  const Surface mesh = readSurface(options.score_mesh);
  const GroundTruth truth = readGroundTruth(options.score_truth);
  checkGroundTruth(truth, mesh.size(), options.score_truth);
  const std::vector<Index> partners = readMap(options.scored_map, mesh.size());
  const ThreadScope threads(options.run.parameters.threads);
  const MapAccuracy score = scoreMap(mesh, truth, partners);
  printScore(std::cout, score);
  if (!options.json.empty())
    writeJsonScore(options.json, score);
  return exit_done;
}

int
runEvidence(const BenchmarkOptions& options)
{
  checkWritableFiles({options.evidence, options.vertex_evidence});
  const auto collect = options.contenders ? collectContenders : collectEvidence;
  const std::vector<EvidenceRow> rows = collect(selectModels(options), options.run, options.jobs, std::cerr);
  writeEvidence(options.evidence, rows);
  if (!options.vertex_evidence.empty())
    writeVertexEvidence(options.vertex_evidence, rows);
  std::cout << rows.size() << " maps in " << options.evidence << '\n';
  return rows.empty() ? exit_failed : exit_done;
}

int
runPaper(BenchmarkOptions& options)
{
  const std::vector<BenchmarkModel> models = selectModels(options);
  std::filesystem::create_directories(options.paper);
  const std::string page = (std::filesystem::path(options.paper) / paper_page).string();
  checkWritableFiles({page});
  const auto run_with = [&](Method method) {
    options.run.parameters.method = method;
    std::cout << nameOf(method_names, method) << '\n';
    printModelHeader(std::cout);
    return runModels(models, options.run, options.jobs, [&options](const ModelRun& run) {
      printModel(std::cout, run, options.verbose);
      std::cout.flush();
    });
  };
  PaperRuns runs;
  runs.staged = run_with(Method::Staged);
  std::cout << '\n';
  runs.robust = run_with(Method::Robust);
  writePaper(options.paper, runs, options.run);
  std::cout << "\ntables and figures in " << page << '\n';
  const auto failed = [](const ModelRun& run) {
    return !run.failure.empty();
  };
  return std::any_of(runs.staged.begin(), runs.staged.end(), failed) ||
                 std::any_of(runs.robust.begin(), runs.robust.end(), failed)
             ? exit_failed
             : exit_done;
}

int
runGraphs(const BenchmarkOptions& options)
{
  const std::vector<GraphRun> runs = compareGraphs(selectModels(options), options.run, options.jobs);
  printGraphs(std::cout, runs);
  return std::any_of(runs.begin(), runs.end(), [](const GraphRun& run) { return !run.failure.empty(); }) ? exit_failed
                                                                                                         : exit_done;
}

int
runNames(const BenchmarkOptions& options)
{
  std::vector<BenchmarkModel> models = selectModels(options);
  models.erase(std::remove_if(models.begin(), models.end(),
                              [](const BenchmarkModel& model) { return findSideTruth(model).empty(); }),
               models.end());
  bool is_complete = true;
  const std::vector<NamePairs> rows =
      compareAllNames(models, options.run, options.exchanged, options.jobs, [&is_complete](const NamedModel& model) {
        std::cerr << model.model.name << ": " << model.failure << '\n';
        is_complete = false;
      });
  printNames(std::cout, rows);
  return is_complete ? exit_done : exit_failed;
}

int
runAblation(const BenchmarkOptions& options)
{
  const std::vector<std::vector<ModelRun>> runs = runAblations(selectModels(options), options.run, options.jobs);
  printAblations(std::cout, runs);
  bool is_complete = true;
  for (const ModelRun& run : runs.front())
    if (!run.failure.empty()) {
      std::cerr << run.model.set << '/' << run.model.name << ": " << run.failure << '\n';
      is_complete = false;
    }
  return is_complete ? exit_done : exit_failed;
}

void
printResults(const BenchmarkOptions& options, const std::vector<ModelRun>& runs)
{
  if (options.run.cut_limb) {
    std::cout << '\n';
    printRefusals(std::cout, runs);
    return;
  }
  if (options.variants > 0) {
    std::cout << '\n';
    printVariants(std::cout, summariseVariants(runs));
    return;
  }
  const std::vector<GroupSummary> classes = summariseClasses(runs);
  if (classes.empty())
    return;
  std::cout << '\n';
  printSummaries(std::cout, classes, summariseSets(classes));
  std::cout << '\n';
  printConfidence(std::cout, runs);
}

int
runDataSets(const BenchmarkOptions& options)
{
  const std::vector<BenchmarkModel> models = selectModels(options);
  std::vector<std::string> inputs;
  for (const BenchmarkModel& model : models) {
    inputs.push_back(model.file);
    const std::size_t second_file = model.truth.find(".vts:");
    inputs.push_back(model.truth.substr(0, second_file == std::string::npos ? second_file : second_file + 4));
  }
  checkDistinct(options.outputs(), inputs);
  checkWritableFiles(options.outputs());
  if (!options.map_folder.empty())
    std::filesystem::create_directories(options.map_folder);
  printModelHeader(std::cout);
  const std::vector<ModelRun> runs = runModels(models, options.run, options.jobs, [&options](const ModelRun& run) {
    printModel(std::cout, run, options.verbose);
    std::cout.flush();
  });
  printResults(options, runs);
  const auto failed = [](const ModelRun& run) {
    return !run.failure.empty();
  };
  if (!options.map_folder.empty())
    for (const ModelRun& run : runs)
      if (!failed(run))
        writeRunMap(options.map_folder, run);
  writeReports(options, runs);
  return std::any_of(runs.begin(), runs.end(), failed) ? exit_failed : exit_done;
}

int
runWith(BenchmarkOptions& options, const CommandLine& line)
{
  completeOptions(options, line);
  if (!options.scored_map.empty())
    return scoreExistingMap(options);
  if (!options.evidence.empty())
    return runEvidence(options);
  if (!options.paper.empty())
    return runPaper(options);
  if (options.names)
    return runNames(options);
  if (options.ablation)
    return runAblation(options);
  return options.graph ? runGraphs(options) : runDataSets(options);
}

} // namespace

int
main(int argc, char** argv)
{
  return runCommand("pcl_symmetry_benchmark", argc, argv, describeOptions, runWith);
}
