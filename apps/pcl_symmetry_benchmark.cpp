/** \file
 * \brief pcl_symmetry_benchmark: runs the estimation on published data sets and prints the field's metrics.
 */
#include "base/error_text.h"
#include "benchmark/error_curve_plot.h"
#include "benchmark/evidence.h"
#include "benchmark/graph_accuracy.h"
#include "benchmark/map_file.h"
#include "benchmark/report_files.h"
#include "benchmark/report_table.h"
#include "benchmark/run.h"
#include "io/write/output_file.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <boost/program_options.hpp>
#include <pcl/exceptions.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>

namespace po = boost::program_options;
using namespace pcl::symmetry;

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::string folder;
  std::vector<std::string> sets;
  std::vector<std::string> classes;
  bool all = false;
  bool graph = false;
  std::string evidence;
  RunOptions run;
  unsigned jobs = 1;
  std::string map_folder;
  std::string csv;
  std::string json;
  std::string plot;
  bool verbose = false;

  std::string scored_map; ///< not empty: score this map of score_mesh instead of running anything
  std::string score_mesh;
  std::string score_truth;
};

po::options_description
describeOptions()
{
  po::options_description selection("Models");
  selection.add_options()("set", po::value<std::vector<std::string>>(), "only this data set (repeatable)")(
      "class", po::value<std::vector<std::string>>(),
      "only this class (repeatable)")("all", "also models without ground truth, which are run but not scored");
  po::options_description method("Method");
  method.add_options()("method", po::value<std::string>()->default_value("robust"),
                       "robust or staged")("metric", po::value<std::string>()->default_value("geodesic"),
                                           "geodesic or euclidean")("as-cloud", "leave the faces out of the input")(
      "graph", "compare distances in the graph of the cloud with those along the mesh; prints this table only")(
      "neighbours,k", po::value<int>(), "neighbours of a point in the graph of a cloud")(
      "landmarks", po::value<int>(),
      "sources of full distance fields")("samples", po::value<int>(), "evenly spaced samples, 0: the method's default")(
      "jobs", po::value<int>()->default_value(1), "models at a time, 0: one per core")(
      "threads", po::value<int>(), "threads of each estimation, 0: one per core (default 0; 1 with several jobs)");
  po::options_description disturbance("Disturbance (points that are left are scored)");
  disturbance.add_options()(
      "cut-limb", po::value<std::string>(),
      "cut off a limb, farthest (its end from its counterpart's) or other: what is left should be "
      "refused, and is not scored")("drop", po::value<double>(), "drop this share of the points at random")(
      "holes", po::value<int>(), "cut this many holes")("hole-share", po::value<double>(),
                                                        "share of the points in all holes (default 0.2)")(
      "thin", po::value<double>(), "drop points in a random direction down to 1/this of the density")(
      "noise", po::value<double>(), "move points, standard deviation over the bounding box's diagonal")(
      "quantise", po::value<double>(), "round coordinates to multiples of this share of the diagonal")(
      "repeat", po::value<double>(), "add this share of points that are there already")(
      "outliers", po::value<double>(), "add this share of points at random places")(
      "seed", po::value<std::int64_t>(), "of the disturbance, any integer (default 1)");
  po::options_description output("Output");
  output.add_options()("csv", po::value<std::string>(), "write one line per model to this file")(
      "json", po::value<std::string>(), "write all figures to this file")(
      "evidence", po::value<std::string>(),
      "write all that is measured on every map of every interpretation to this .csv file, delivered or not, instead of "
      "the scores: what the confidence is calibrated with")("plot", po::value<std::string>(),
                                                            "draw the geodesic error curves into this .svg file")(
      "map-dir", po::value<std::string>(), "write each map as SET_MODEL.csv into this folder")(
      "verbose", "seconds per step and properties of the map for each model")("help", "print this text")(
      "version", "print the version");
  po::options_description score("One existing map (instead of DIR)");
  score.add_options()("score", po::value<std::string>(), "score this map, lines vertex,partner")(
      "mesh", po::value<std::string>(), "surface that the map belongs to")(
      "truth", po::value<std::string>(), "CLASS.pid, MODEL.vts:N.sym.info or a dense list, 1-based");
  po::options_description visible;
  return visible.add(selection).add(method).add(disturbance).add(output).add(score);
}

po::variables_map
parseArguments(int argc, char** argv, const po::options_description& visible)
{
  po::options_description all;
  all.add(visible).add_options()("folder", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("folder", 1);
  po::variables_map arguments;
  const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(), arguments);
  po::notify(arguments);
  return arguments;
}

template <typename Value>
void
take(const po::variables_map& arguments, const char* name, Value& target)
{
  if (arguments.count(name) > 0)
    target = arguments[name].as<Value>();
}

/** A count; Boost alone would read "-1" as 4294967295. */
unsigned
takeCount(const po::variables_map& arguments, const char* name, unsigned otherwise)
{
  if (arguments.count(name) == 0)
    return otherwise;
  const int value = arguments[name].as<int>();
  if (value < 0 || value > 1024)
    throw UsageError("--" + std::string(name) + " " + std::to_string(value) + " is not in [0, 1024]");
  return static_cast<unsigned>(value);
}

template <typename Value>
Value
takeChoice(const po::variables_map& arguments,
           const char* name,
           const std::vector<std::pair<std::string, Value>>& choices)
{
  const auto text = arguments[name].as<std::string>();
  std::string names;
  for (const auto& [choice, value] : choices) {
    if (choice == text)
      return value;
    names += (names.empty() ? "" : " or ") + choice;
  }
  throw UsageError("--" + std::string(name) + " is " + names + ", and not '" + text + "'");
}

SymmetryParameters
takeParameters(const po::variables_map& arguments, unsigned jobs)
{
  SymmetryParameters parameters;
  parameters.method = takeChoice<Method>(arguments, "method", {{"robust", Method::Robust}, {"staged", Method::Staged}});
  parameters.metric =
      takeChoice<Metric>(arguments, "metric", {{"geodesic", Metric::Geodesic}, {"euclidean", Metric::Euclidean}});
  take(arguments, "neighbours", parameters.k_search);
  take(arguments, "landmarks", parameters.landmarks);
  take(arguments, "samples", parameters.samples);
  parameters.threads = takeCount(arguments, "threads", jobs == 1 ? 0 : 1);
  return parameters;
}

Disturbance
takeDisturbance(const po::variables_map& arguments)
{
  Disturbance disturbance;
  take(arguments, "noise", disturbance.noise);
  take(arguments, "drop", disturbance.drop);
  take(arguments, "outliers", disturbance.outliers);
  disturbance.holes = takeCount(arguments, "holes", 0);
  take(arguments, "hole-share", disturbance.hole_share);
  take(arguments, "thin", disturbance.thin);
  take(arguments, "quantise", disturbance.quantise);
  take(arguments, "repeat", disturbance.repeat);
  if (arguments.count("seed") > 0)
    disturbance.seed = static_cast<std::uint64_t>(arguments["seed"].as<std::int64_t>());
  return disturbance;
}

void
checkRunOptions(const RunOptions& options)
{
  try {
    checkParameters(options.parameters);
    checkDisturbance(options.disturbance);
  }
  catch (const pcl::BadArgumentException& error) {
    throw UsageError(errorText(error));
  }
}

void
checkCombination(const Options& options)
{
  const bool scores_map = !options.scored_map.empty();
  if (scores_map != !options.score_mesh.empty() || scores_map != !options.score_truth.empty())
    throw UsageError("--score, --mesh and --truth belong together");
  if (scores_map && (!options.csv.empty() || !options.plot.empty()))
    throw UsageError("--score writes --json only, neither --csv nor --plot");
  if (scores_map == !options.folder.empty())
    throw UsageError(scores_map ? "either DIR or --score" : "DIR, a folder with data sets, is missing");
  if (!options.evidence.empty() && (options.graph || !options.csv.empty() || !options.json.empty() ||
                                    !options.plot.empty() || !options.map_folder.empty()))
    throw UsageError("--evidence writes nothing else: it goes with no other output");
  if (options.graph && (options.run.as_cloud || !options.csv.empty() || !options.json.empty() ||
                        !options.plot.empty() || !options.map_folder.empty()))
    throw UsageError("--graph finds no maps: it goes with neither --as-cloud nor an output file");
  if (options.graph && options.run.cut_limb)
    throw UsageError("--graph needs whole models: it does not go with --cut-limb");
}

Options
takeOptions(const po::variables_map& arguments)
{
  Options options;
  take(arguments, "folder", options.folder);
  take(arguments, "set", options.sets);
  take(arguments, "class", options.classes);
  options.all = arguments.count("all") > 0;
  options.jobs = takeCount(arguments, "jobs", 1);
  options.run.parameters = takeParameters(arguments, options.jobs);
  options.graph = arguments.count("graph") > 0;
  options.run.as_cloud = arguments.count("as-cloud") > 0;
  options.run.disturbance = takeDisturbance(arguments);
  if (arguments.count("cut-limb") > 0)
    options.run.cut_limb =
        takeChoice<Limb>(arguments, "cut-limb", {{"farthest", Limb::Farthest}, {"other", Limb::Other}});
  checkRunOptions(options.run);
  take(arguments, "map-dir", options.map_folder);
  take(arguments, "csv", options.csv);
  take(arguments, "json", options.json);
  take(arguments, "plot", options.plot);
  options.verbose = arguments.count("verbose") > 0;
  take(arguments, "evidence", options.evidence);
  take(arguments, "score", options.scored_map);
  take(arguments, "mesh", options.score_mesh);
  take(arguments, "truth", options.score_truth);
  checkCombination(options);
  return options;
}

/** Refuses a file that would overwrite another or what is read. */
void
checkOutputs(const Options& options, std::vector<std::string> taken)
{
  for (const std::string& file : {options.csv, options.json, options.plot, options.evidence}) {
    if (file.empty())
      continue;
    if (std::any_of(taken.begin(), taken.end(), [&file](const std::string& other) { return areOneFile(file, other); }))
      throw UsageError("'" + file + "' would be overwritten: each file needs a name of its own");
    taken.push_back(file);
  }
}

bool
isSelected(const std::vector<std::string>& wanted, const std::string& name)
{
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

std::vector<BenchmarkModel>
selectModels(const Options& options)
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
  result.sides.resize(run.points, Side::None);
  result.regions.resize(run.points, Region::None);
  writeMap((std::filesystem::path(folder) / (run.model.set + "_" + run.model.name + ".csv")).string(), result);
}

void
writeReports(const Options& options, const std::vector<ModelRun>& runs)
{
  if (!options.csv.empty())
    writeCsvReport(options.csv, runs);
  if (!options.json.empty())
    writeJsonReport(options.json, runs, options.run);
  if (!options.plot.empty())
    writeErrorCurves(options.plot, errorCurves(runs));
}

int
scoreExistingMap(const Options& options)
{
  checkOutputs(options, {options.scored_map, options.score_mesh, options.score_truth});
  const Surface mesh = readSurface(options.score_mesh);
  const GroundTruth truth = readGroundTruth(options.score_truth);
  checkGroundTruth(truth, mesh.size(), options.score_truth);
  const std::vector<Index> partners = readMap(options.scored_map, mesh.size());
  const MapAccuracy score = scoreMap(mesh, truth, partners, options.run.parameters.threads);
  printScore(std::cout, score);
  if (!options.json.empty())
    writeJsonScore(options.json, score);
  return exit_done;
}

int
runEvidence(const Options& options)
{
  checkOutputs(options, {});
  checkWritable(options.evidence);
  const std::vector<EvidenceRow> rows = collectEvidence(selectModels(options), options.run, options.jobs, std::cerr);
  writeEvidence(options.evidence, rows);
  std::cout << rows.size() << " maps in " << options.evidence << '\n';
  return rows.empty() ? exit_failed : exit_done;
}

int
runGraphs(const Options& options)
{
  const std::vector<GraphRun> runs = compareGraphs(selectModels(options), options.run, options.jobs);
  printGraphs(std::cout, runs);
  return std::any_of(runs.begin(), runs.end(), [](const GraphRun& run) { return !run.failure.empty(); }) ? exit_failed
                                                                                                         : exit_done;
}

void
printResults(const Options& options, const std::vector<ModelRun>& runs)
{
  if (options.run.cut_limb) {
    std::cout << '\n';
    printRefusals(std::cout, runs);
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
runDataSets(const Options& options)
{
  const std::vector<BenchmarkModel> models = selectModels(options);
  std::vector<std::string> inputs;
  for (const BenchmarkModel& model : models) {
    inputs.push_back(model.file);
    const std::size_t second_file = model.truth.find(".vts:");
    inputs.push_back(model.truth.substr(0, second_file == std::string::npos ? second_file : second_file + 4));
  }
  checkOutputs(options, inputs);
  for (const std::string& file : {options.csv, options.json, options.plot})
    if (!file.empty())
      checkWritable(file);
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
run(int argc, char** argv)
{
  const po::options_description visible = describeOptions();
  const po::variables_map arguments = parseArguments(argc, argv, visible);
  if (arguments.count("help") > 0) {
    std::cout << "Usage: pcl_symmetry_benchmark DIR [options]\n"
                 "       pcl_symmetry_benchmark --score MAP.csv --mesh FILE --truth TRUTH [--json FILE]\n\n"
                 "Finds the symmetry of every model of the data sets in DIR and compares it with the ground truth.\n"
              << visible;
    return exit_done;
  }
  if (arguments.count("version") > 0) {
    std::cout << "pcl_symmetry_benchmark " PCL_SYMMETRY_VERSION "\n";
    return exit_done;
  }
  const Options options = takeOptions(arguments);
  const int status = !options.scored_map.empty() ? scoreExistingMap(options)
                     : options.graph             ? runGraphs(options)
                     : !options.evidence.empty() ? runEvidence(options)
                                                 : runDataSets(options);
  if (!std::cout.flush())
    throw pcl::IOException("standard output: cannot be written");
  return status;
}

} // namespace

int
main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error with a message
  try {
    return run(argc, argv);
  }
  catch (const po::error& error) {
    std::cerr << "pcl_symmetry_benchmark: " << error.what() << " (see --help)\n";
    return exit_usage;
  }
  catch (const UsageError& error) {
    std::cerr << "pcl_symmetry_benchmark: " << error.what() << " (see --help)\n";
    return exit_usage;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_symmetry_benchmark: " << errorText(error) << '\n';
    return exit_failed;
  }
}
