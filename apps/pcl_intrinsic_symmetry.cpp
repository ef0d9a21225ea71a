/** \file
 * \brief pcl_intrinsic_symmetry: finds the intrinsic symmetry of a surface and writes what was found.
 */
#include "base/error_text.h"
#include "cli/command_line.h"
#include "cli/output_names.h"
#include "cli/parameter_options.h"
#include "cli/program.h"
#include "cli/progress_line.h"
#include "cli/stopwatch.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

using namespace pcl::symmetry;

namespace {

constexpr const char* program = "pcl_intrinsic_symmetry";
constexpr const char* standard_stream = "-"; ///< standard input or output

/** \brief The data were read, but are no surface that can be judged. */
struct Unjudged : std::runtime_error {
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

  std::vector<std::string>
  all() const
  {
    return {labelled, map, correspondences, axis, report, picture};
  }

  /** \brief Whether standard output is one of them. */
  bool
  takeStandardOutput() const
  {
    return map == standard_stream || correspondences == standard_stream || report == standard_stream;
  }
};

struct Options {
  std::string input;
  std::string format;    ///< of the input; empty: by its ending
  std::string reference; ///< labelled surface that the sides are named like; empty: none
  Outputs outputs;
  SymmetryParameters parameters;
  int samples = 0; ///< of the method that is chosen; 0: its default
  bool as_cloud = false;
  bool require_whole = false;
  bool quiet = false;
};

CommandLine
describeOptions(Options& options)
{
  Outputs& outputs = options.outputs;
  SymmetryParameters& parameters = options.parameters;

  OptionGroup output("Output");
  output.file("output,o", outputs.labelled, "labelled surface, .ply (with faces) or .pcd");
  output.file("map", outputs.map, "partner of each point, CSV");
  output.file("correspondences", outputs.correspondences, "sparse matches, CSV");
  output.file("axis", outputs.axis, "symmetry axis curve, .ply, .pcd or .csv");
  output.file("report", outputs.report, "what was found, how and how fast, JSON");
  output.file("picture", outputs.picture, "front and back, .png");

  OptionGroup method("Method");
  method.file("like", options.reference,
              "name the sides as in this labelled surface (--output of an earlier run): another pose, or another body "
              "of the kind");
  method.choice("method", parameters.method, method_names, "robust, or staged: the published method step by step");
  method.choice("metric", parameters.metric, metric_names, "geodesic, or euclidean: right only in a symmetric pose");
  method.choice("components", parameters.components, component_use_names,
                "all parts of one object, or largest: one connected component");
  method.flag("require-whole", options.require_whole,
              "a surface of which a part has no counterpart is not symmetric: exit status 3");
  method.flag("sparse", parameters.sparse_only, "leave out the dense map and alternatives");
  method.choice("label-axis", parameters.label_axis, switch_names,
                "on, or off: points at the axis are labelled as on one of the sides");
  method.number("landmarks", parameters.staged.landmarks, "N",
                "of the staged method: sources of full distance fields, 10 to 1000");
  method.number("samples", options.samples, "N",
                "evenly spaced samples of the method, 30 (staged: 20) to 20000; 0: 1500 (staged: 100)",
                Default::Hidden);
  method.number("alternatives", parameters.alternatives, "N",
                "list up to N reflections, and apart from them the rotations, in the report");
  method.choice("extremities", parameters.staged.extremities, extreme_points_names,
                "of the staged method: the limbs' tips are two pairs among nine farthest points, or the first four");
  method.choice("pairing", parameters.staged.pairing, pairing_names, "what pairs the first four: agd, mgd or size");
  method.count("threads", parameters.threads, thread_limit, "0: one per core");

  OptionGroup cloud("Clouds");
  cloud.flag("as-cloud", options.as_cloud, "ignore the faces of the file");
  cloud.number("neighbours,k", parameters.k_search, "N", "neighbours of a point, 3 to 256");
  cloud.number("radius", parameters.radius, "R", "longest edge between neighbours, in the unit of the points",
               Default::Hidden);
  cloud.choice("normals", parameters.normals, normal_source_names, "estimate, or given: those of the file");
  cloud.number("outliers", parameters.outlier_deviations, "D",
               "drop points whose neighbours are farther than the mean by D standard deviations, too", Default::Hidden);

  OptionGroup general("General");
  general.word("format", options.format, "FORMAT",
               "of INPUT where its name does not tell: pcd, ply, obj, off, stl, vtk, xyz");
  general.flag("quiet,q", options.quiet, "no progress, no summary");

  CommandLine line(program,
                   "pcl_intrinsic_symmetry INPUT [options]\n\n"
                   "Finds the symmetric partner of each point of a surface, the two sides and the axis between them.\n"
                   "INPUT is a .pcd, .ply, .obj, .off, .stl, .vtk or .xyz (.txt, .asc, .pts) file, or such a file\n"
                   "compressed (.gz). The name - is standard input, with --format, and for --map, --correspondences "
                   "and --report standard output.\n",
                   "\nExit status: 0 done, 1 cannot read, write or compute, 2 wrong usage, 3 no symmetry found.\n");
  line.add(output);
  line.add(method);
  line.add(cloud);
  line.addLast(general);
  return line;
}

void
checkOptions(const Options& options)
{
  checkParameterOptions(options.parameters);
  if (options.parameters.sparse_only && !options.outputs.map.empty())
    throw UsageError("--map is the dense map, which --sparse leaves out");
  checkEnding("output", options.outputs.labelled, {".ply", ".pcd"});
  checkEnding("axis", options.outputs.axis, {".ply", ".pcd", ".csv"});
  checkEnding("picture", options.outputs.picture, {".png"});
  if (options.parameters.sparse_only && !options.reference.empty())
    throw UsageError("--like compares dense maps, which --sparse leaves out");
  checkDistinct(options.outputs.all(), {options.input, options.reference});
  const std::vector<std::string> formats = {"", "pcd", "ply", "obj", "off", "stl", "vtk", "xyz"};
  if (std::find(formats.begin(), formats.end(), options.format) == formats.end())
    throw UsageError("--format is pcd, ply, obj, off, stl, vtk or xyz, not '" + options.format + "'");
  if (options.input == standard_stream && options.format.empty())
    throw UsageError("standard input needs --format");
}

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
    points += line.curve.size();
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

/** \brief Such as "  2 parts without counterpart: 8.1 % around point 5012, 1.9 % around point 77". */
std::string
describeUnsupported(const SymmetryResult& result)
{
  constexpr std::size_t named = 3;
  const std::size_t count = result.unsupported.size();
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "  " << count << (count == 1 ? " part" : " parts")
       << " without counterpart:";
  for (std::size_t k = 0; k < std::min(named, count); ++k)
    text << (k == 0 ? " " : ", ") << 100.0F * result.unsupported[k].share << " % around point "
         << result.unsupported[k].extreme;
  return text.str();
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
  if (hasMap(result.status))
    text << "  " << result.map.matched << " of " << result.input.points << " points matched  "
         << describeAxis(result.axis);
  if (!result.unsupported.empty())
    text << describeUnsupported(result);
  if (result.naming.by_reference)
    text << "  sides named by reference, margin " << result.naming.margin;
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

/** \brief Says that the names of the sides may well be wrong; empty where they need not be doubted. */
std::string
adviceOnNames(const Options& options, const SideNaming& naming)
{
  if (!naming.by_reference || naming.margin >= pcl::symmetry::SideNaming::doubtful)
    return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << program << ": warning: " << options.reference
       << " hardly tells which side is which: margin " << naming.margin << '\n';
  return text.str();
}

/** \brief What to do about a map that may well be wrong; empty where it need not be doubted. */
std::string
adviceOn(const SymmetryResult& result)
{
  constexpr float doubtful = 2.0F / 3.0F; // of three such maps one is wrong
  if (!hasMap(result.status) || result.confidence >= doubtful)
    return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << program << ": warning: a confidence of " << result.confidence
       << " is low: look at the map (--picture) before using it";
  if (result.input.used < result.input.points)
    text << ", and at what was left out (--report)";
  return text.str() + "\n";
}

void
printSummary(const Options& options, const SymmetryResult& result)
{
  if (options.quiet)
    return;
  (options.outputs.takeStandardOutput() ? std::cerr : std::cout) << summarize(result) << '\n';
  std::cerr << adviceOn(result) << adviceOnNames(options, result.naming);
}

/** \brief Reads, estimates and writes. */
int
work(const Options& options)
{
  const Stopwatch reading;
  Surface surface = readSurface(options.input, options.format);
  if (options.as_cloud)
    surface.triangles.clear();
  std::optional<NameReference> reference;
  if (!options.reference.empty())
    reference = readNameReference(options.reference, options.parameters.threads);
  const double read_seconds = reading.seconds();

  SymmetryResult result = estimate(options, surface);
  result.seconds.insert(result.seconds.begin(), {"read", read_seconds});
  if (reference) {
    const Stopwatch naming;
    reference->nameSides(surface, result, options.parameters.threads);
    result.seconds.emplace_back("names", naming.seconds());
  }
  result.input.notes = surface.notes;
  const Stopwatch writing;
  const bool is_judged = hasMap(result.status) || result.status == SymmetryStatus::NoSymmetry;
  if (is_judged) // else what was found for this surface before is worth more
    writeOutputs(options.outputs, surface, result);
  // The report comes last, and holds the time of all that was written before it.
  result.seconds.emplace_back("write", writing.seconds());
  if (!options.outputs.report.empty())
    writeReport(options.outputs.report, options.input, options.parameters, result);

  if (!is_judged)
    throw Unjudged(options.input + ": " + toString(result.status) + ": " + result.message);
  printSummary(options, result);
  const bool is_enough = options.require_whole ? result.status == SymmetryStatus::Symmetric : hasMap(result.status);
  return is_enough ? exit_done : exit_no_symmetry;
}

/** \brief A run that fails leaves a report as well, so that a table of many runs has a row for it. */
int
run(const Options& options)
{
  checkWritableFiles(options.outputs.all());
  try {
    return work(options);
  }
  catch (const Unjudged&) {
    throw; // has a report
  }
  catch (const std::exception& error) {
    if (!options.outputs.report.empty())
      writeFailureReport(options.outputs.report, options.input, options.parameters, errorText(error));
    throw;
  }
}

int
runWith(Options& options, const CommandLine& line)
{
  options.input = line.onlyWord("INPUT", "a file");
  setSamples(options.parameters, options.samples);
  checkOptions(options);
  return run(options);
}

} // namespace

int
main(int argc, char** argv)
{
  cleanUpOnSignal(removeUnfinishedFiles);
  return runCommand(program, argc, argv, describeOptions, runWith);
}
