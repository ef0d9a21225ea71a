/** \file
 * \brief pcl_intrinsic_symmetry: finds the intrinsic symmetry of a surface and writes what was found.
 */
#include "base/error_text.h"
#include "io/write/output_file.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <boost/program_options.hpp>
#include <pcl/exceptions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace po = boost::program_options;
using namespace pcl::symmetry;

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_usage = 2;
constexpr int exit_no_symmetry = 3;

/** \brief A mistake in the command line. */
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** \brief Files to write; an empty name: not wanted. */
struct Outputs {
  std::string labelled;
  std::string map;
  std::string correspondences;
  std::string axis;
  std::string report;
  std::string picture;
};

struct Options {
  std::string input;
  Outputs outputs;
  SymmetryParameters parameters;
  bool as_cloud = false;
  bool quiet = false;
};

/** \brief Words of the command line that are not yet values of their parameter. */
struct Words {
  std::string method = "robust";
  std::string metric = "geodesic";
  std::string normals = "estimate";
  std::string pairing = "agd";
  int threads = 0;
};

po::options_description
describeOptions(Options& options, Words& words)
{
  const auto file = [](std::string& name) {
    return po::value(&name)->value_name("FILE");
  };
  const auto word = [](std::string& text, const char* name) {
    return po::value(&text)->default_value(text)->value_name(name);
  };
  const auto number = [](auto& value) {
    return po::value(&value)->default_value(value)->value_name("N");
  };
  Outputs& outputs = options.outputs;
  SymmetryParameters& parameters = options.parameters;

  po::options_description output("Output");
  auto add_output = output.add_options();
  add_output("output,o", file(outputs.labelled), "labelled surface, .ply (with faces) or .pcd");
  add_output("map", file(outputs.map), "partner of each point, CSV");
  add_output("correspondences", file(outputs.correspondences), "sparse matches, CSV");
  add_output("axis", file(outputs.axis), "symmetry axis curve, .ply or .pcd");
  add_output("report", file(outputs.report), "what was found, how and how fast, JSON");
  add_output("picture", file(outputs.picture), "front and back, .png");

  po::options_description method("Method");
  auto add_method = method.add_options();
  add_method("method", word(words.method, "NAME"), "robust, or staged: the published method step by step");
  add_method("metric", word(words.metric, "NAME"), "geodesic, or euclidean: faster, right only in a symmetric pose");
  add_method("sparse", "leave out the dense map and alternatives");
  add_method("landmarks", number(parameters.landmarks),
             "of the staged method: sources of full distance fields, 10 to 1000");
  add_method("samples", number(parameters.samples),
             "evenly spaced samples, 30 (staged: 20) to 20000; 0: the method's default");
  add_method("alternatives", number(parameters.alternatives),
             "list up to N reflections, and apart from them the rotations, in the report");
  add_method("pairing", word(words.pairing, "NAME"),
             "what pairs the extreme points of the staged method: agd, mgd or size");
  add_method("threads", po::value(&words.threads)->default_value(0)->value_name("N"), "0: one per core");

  po::options_description cloud("Clouds");
  auto add_cloud = cloud.add_options();
  add_cloud("as-cloud", "ignore the faces of the file");
  add_cloud("neighbours,k", number(parameters.k_search), "neighbours of a point, 3 to 256");
  add_cloud("radius", po::value(&parameters.radius)->value_name("R"),
            "longest edge between neighbours, in the unit of the points");
  add_cloud("normals", word(words.normals, "NAME"), "estimate, or given: those of the file");
  add_cloud("outliers", po::value(&parameters.outlier_deviations)->value_name("D"),
            "drop points whose neighbours are farther than the mean by D standard deviations, too");

  po::options_description general("General");
  general.add_options()("quiet,q", "no progress, no summary")("help,h", "print this text")("version",
                                                                                           "print the version");
  po::options_description all;
  return all.add(output).add(method).add(cloud).add(general);
}

po::variables_map
parseArguments(int argc, char** argv, const po::options_description& visible, std::vector<std::string>& inputs)
{
  po::options_description all;
  all.add(visible).add_options()("input", po::value(&inputs));
  po::positional_options_description positional;
  positional.add("input", -1);
  const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::variables_map arguments;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(), arguments);
  po::notify(arguments);
  return arguments;
}

template <typename Value>
Value
choose(const char* option, const std::string& word, const std::vector<std::pair<std::string, Value>>& choices)
{
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == word)
      return value;
    names += (names.empty() ? "" : " or ") + name;
  }
  throw UsageError("--" + std::string(option) + " is " + names + ", not '" + word + "'");
}

/** \brief A message that begins with the name of a parameter, with that of its option instead. */
std::string
inOptions(const std::string& message)
{
  for (const auto& [name, option] : {std::pair("k_search", "--neighbours"),
                                     {"outlier_deviations", "--outliers"},
                                     {"radius", "--radius"},
                                     {"landmarks", "--landmarks"},
                                     {"samples", "--samples"},
                                     {"alternatives", "--alternatives"}})
    if (message.rfind(name, 0) == 0)
      return option + message.substr(std::string(name).size());
  return message;
}

void
takeParameters(const Words& words, SymmetryParameters& parameters)
{
  parameters.method = choose<Method>("method", words.method, {{"robust", Method::Robust}, {"staged", Method::Staged}});
  parameters.metric =
      choose<Metric>("metric", words.metric, {{"geodesic", Metric::Geodesic}, {"euclidean", Metric::Euclidean}});
  parameters.normals = choose<NormalSource>("normals", words.normals,
                                            {{"estimate", NormalSource::Estimate}, {"given", NormalSource::Given}});
  parameters.pairing = choose<PairingFeature>("pairing", words.pairing,
                                              {{"agd", PairingFeature::AverageGeodesicDistance},
                                               {"mgd", PairingFeature::MinimalGeodesicDistance},
                                               {"size", PairingFeature::BySurfaceSize}});
  // Boost would read "-1" into an unsigned number as 4294967295.
  constexpr int most_threads = 1024;
  if (words.threads < 0 || words.threads > most_threads)
    throw UsageError("--threads " + std::to_string(words.threads) + " is not in [0, " + std::to_string(most_threads) +
                     "]");
  parameters.threads = static_cast<unsigned>(words.threads);
  try {
    checkParameters(parameters);
  }
  catch (const pcl::BadArgumentException& error) {
    throw UsageError(inOptions(errorText(error)));
  }
}

/** \brief Refuses names that are there but empty: an unset variable of a script, most likely. */
void
refuseEmptyNames(const po::variables_map& arguments)
{
  for (const char* option : {"output", "map", "correspondences", "axis", "report", "picture"})
    if (arguments.count(option) > 0 && arguments[option].as<std::string>().empty())
      throw UsageError("--" + std::string(option) + " needs the name of a file");
}

void
checkEnding(const char* option, const std::string& path, const std::vector<std::string>& endings)
{
  if (path.empty() || std::find(endings.begin(), endings.end(), fileEnding(path)) != endings.end())
    return;
  std::string names;
  for (const std::string& ending : endings)
    names += (names.empty() ? "" : " or ") + ending;
  throw UsageError("--" + std::string(option) + " writes " + names + ", not '" + path + "'");
}

std::vector<std::string>
wantedFiles(const Outputs& outputs)
{
  std::vector<std::string> files;
  for (const std::string* file :
       {&outputs.labelled, &outputs.map, &outputs.correspondences, &outputs.axis, &outputs.report, &outputs.picture})
    if (!file->empty())
      files.push_back(*file);
  return files;
}

/** \brief Refuses endings that nothing is written for, and a file that would overwrite another or the input. */
void
checkOutputs(const Options& options)
{
  checkEnding("output", options.outputs.labelled, {".ply", ".pcd"});
  checkEnding("axis", options.outputs.axis, {".ply", ".pcd"});
  checkEnding("picture", options.outputs.picture, {".png"});
  std::vector<std::string> taken = {options.input};
  for (const std::string& file : wantedFiles(options.outputs)) {
    const auto is_file = [&file](const std::string& other) {
      return areOneFile(file, other);
    };
    if (std::any_of(taken.begin(), taken.end(), is_file))
      throw UsageError("'" + file + "' would be overwritten: each file needs a name of its own");
    taken.push_back(file);
  }
}

/** \brief Shows the running step on a terminal. */
class ProgressLine {
public:
  explicit ProgressLine(bool quiet) : is_shown_(!quiet && ::isatty(STDERR_FILENO) == 1)
  {
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine&
  operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine&
  operator=(ProgressLine&&) = delete;

  ~ProgressLine()
  {
    if (is_shown_)
      std::fputs(erase_line, stderr);
  }

  void
  show(const char* step, double fraction) const
  {
    if (is_shown_)
      std::fprintf(stderr, "%s%3.0f %%  %s", erase_line, 100.0 * fraction, step);
  }

private:
  static constexpr const char* erase_line = "\r\033[K";
  bool is_shown_;
};

class Stopwatch {
public:
  double
  seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/** \brief Writes all files but the report. */
void
writeOutputs(const Outputs& outputs, const Surface& surface, const SymmetryResult& result)
{
  if (!outputs.labelled.empty())
    writeLabelledSurface(outputs.labelled, surface, result);
  if (!outputs.map.empty())
    writeMap(outputs.map, result);
  if (!outputs.correspondences.empty())
    writeCorrespondences(outputs.correspondences, result);
  if (!outputs.axis.empty())
    writeAxis(outputs.axis, surface, result);
  if (!outputs.picture.empty())
    writePicture(outputs.picture, surface, result);
}

std::string
describeAxis(const std::vector<Polyline>& axis)
{
  std::size_t points = 0;
  std::size_t closed = 0;
  for (const Polyline& line : axis) {
    points += line.points.size();
    closed += line.closed ? 1 : 0;
  }
  const auto curves = [](std::size_t count, const char* kind) {
    return ", " + std::to_string(count) + " " + kind + (count == 1 ? " curve" : " curves");
  };
  std::string text = "axis " + std::to_string(points) + " points";
  if (closed > 0)
    text += curves(closed, "closed");
  if (closed < axis.size())
    text += curves(axis.size() - closed, "open");
  return text;
}

/** \brief One line, such as "symmetric  confidence 0.97  12500 of 12500 points matched  axis 312 points, 1 closed curve
 * 0.31 s". */
std::string
summarize(const SymmetryResult& result)
{
  double seconds = 0.0;
  for (const auto& [step, duration] : result.seconds)
    seconds += duration;
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << toString(result.status) << "  confidence " << result.confidence;
  if (result.status == SymmetryStatus::Symmetric)
    text << "  " << result.map.matched << " of " << result.input.points << " points matched  "
         << describeAxis(result.axis);
  text << "  " << seconds << " s";
  if (!result.message.empty())
    text << "  " << result.message;
  return text.str();
}

SymmetryResult
estimate(const Options& options, const Surface& surface)
{
  const ProgressLine progress(options.quiet);
  try {
    return estimateIntrinsicSymmetry(surface, options.parameters, [&](const char* step, double fraction) {
      progress.show(step, fraction);
      return true;
    });
  }
  catch (const pcl::BadArgumentException& error) {
    throw std::runtime_error(options.input + ": " + errorText(error)); // a parameter that this surface cannot have
  }
}

int
run(const Options& options)
{
  for (const std::string& file : wantedFiles(options.outputs))
    checkWritable(file);
  const Stopwatch reading;
  Surface surface = readSurface(options.input);
  if (options.as_cloud)
    surface.triangles.clear();
  const double read_seconds = reading.seconds();

  SymmetryResult result = estimate(options, surface);
  result.seconds.insert(result.seconds.begin(), {"read", read_seconds});
  const Stopwatch writing;
  writeOutputs(options.outputs, surface, result);
  // The report comes last, and holds the time of all that was written before it.
  result.seconds.emplace_back("write", writing.seconds());
  if (!options.outputs.report.empty())
    writeReport(options.outputs.report, options.input, options.parameters, result);

  if (result.status != SymmetryStatus::Symmetric && result.status != SymmetryStatus::NoSymmetry)
    throw std::runtime_error(options.input + ": " + toString(result.status) + ": " + result.message);
  if (!options.quiet)
    std::cout << summarize(result) << '\n';
  return result.status == SymmetryStatus::Symmetric ? exit_done : exit_no_symmetry;
}

int
runCommand(int argc, char** argv)
{
  Options options;
  Words words;
  std::vector<std::string> inputs;
  const po::options_description visible = describeOptions(options, words);
  const po::variables_map arguments = parseArguments(argc, argv, visible, inputs);
  if (arguments.count("help") > 0) {
    std::cout << "Usage: pcl_intrinsic_symmetry INPUT [options]\n\n"
                 "Finds the symmetric partner of each point of a surface, the two sides and the axis between them.\n"
                 "INPUT is a .pcd, .ply, .obj, .off or .stl file.\n"
              << visible
              << "\nExit status: 0 done, 1 cannot read, write or compute, 2 wrong usage, 3 no symmetry found.\n";
    return exit_done;
  }
  if (arguments.count("version") > 0) {
    std::cout << "pcl_intrinsic_symmetry " PCL_SYMMETRY_VERSION "\n";
    return exit_done;
  }
  if (inputs.size() != 1)
    throw UsageError(inputs.empty() ? "INPUT, a file, is missing" : "more than one INPUT: '" + inputs[1] + "'");
  if (inputs.front().empty())
    throw UsageError("INPUT has no name");
  refuseEmptyNames(arguments);
  options.input = inputs.front();
  options.as_cloud = arguments.count("as-cloud") > 0;
  options.quiet = arguments.count("quiet") > 0;
  options.parameters.sparse_only = arguments.count("sparse") > 0;
  takeParameters(words, options.parameters);
  checkOutputs(options);
  return run(options);
}

int
complain(const std::string& message, int status)
{
  std::cerr << "pcl_intrinsic_symmetry: " << message << '\n';
  if (status == exit_usage)
    std::cerr << "Try 'pcl_intrinsic_symmetry --help'.\n";
  return status;
}

} // namespace

int
main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error with a message
  try {
    const int status = runCommand(argc, argv);
    return std::cout.flush() ? status : complain("the standard output cannot be written to", exit_failed);
  }
  catch (const UsageError& error) {
    return complain(error.what(), exit_usage);
  }
  catch (const po::error& error) {
    return complain(error.what(), exit_usage);
  }
  catch (const std::bad_alloc&) {
    return complain("out of memory", exit_failed);
  }
  catch (const std::exception& error) {
    return complain(errorText(error), exit_failed);
  }
}
