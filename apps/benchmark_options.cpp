#include "benchmark_options.h"

#include "benchmark/disturbance.h"
#include "benchmark/limb_cut.h"
#include "benchmark/variants.h"
#include "cli/option_group.h"
#include "cli/parameter_options.h"
#include "cli/program.h"

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

constexpr const char* program = "pcl_symmetry_benchmark";

constexpr EnumName<Limb> limb_names[] = {{Limb::Farthest, "farthest"}, {Limb::Other, "other"}};

OptionGroup
methodOptions(BenchmarkOptions& options)
{
  SymmetryParameters& parameters = options.run.parameters;
  OptionGroup method("Method");
  method.choice("method", parameters.method, method_names, "robust or staged");
  method.choice("metric", parameters.metric, metric_names, "geodesic or euclidean");
  method.flag("as-cloud", options.run.as_cloud, "leave the faces out of the input");
  method.flag("graph", options.graph,
              "compare distances in the graph of the cloud with those along the mesh; prints this table only");
  method.flag("ablation", options.ablation,
              "run the robust method without one of its ingredients after the other on the first interpretation of "
              "every model; prints this table only");
  method.flag(
      "side-names", options.names,
      "compare the names of the sides of models of a set, with one another as reference and by the shape alone, "
      "where their true sides are known (Sides/CLASS.txt, MODEL_side.txt or side.txt); prints this table only");
  method.words("exchanged", options.exchanged, "CLASS",
               "with --side-names: a class whose file of sides calls right what the others call left (repeatable)");
  method.number("neighbours,k", parameters.k_search, "N", "neighbours of a point in the graph of a cloud");
  method.number("landmarks", parameters.staged.landmarks, "N", "of the staged method: sources of full distance fields");
  method.number("samples", options.samples, "N", "evenly spaced samples of the method; 0: its default");
  method.choice("extremities", parameters.staged.extremities, extreme_points_names,
                "of the staged method: the limbs' tips are two pairs among nine farthest points, or the first four");
  method.count("jobs", options.jobs, thread_limit, "models at a time, 0: one per core");
  method.count("threads", options.threads, thread_limit,
               "threads of each estimation, 0: one per core (default 0; 1 with several jobs)");
  return method;
}

OptionGroup
disturbanceOptions(BenchmarkOptions& options)
{
  Disturbance& disturbance = options.run.disturbance;
  OptionGroup group("Disturbance (points that are left are scored)");
  group.choice("cut-limb", options.run.cut_limb, limb_names,
               "cut off a limb, farthest (its end from its counterpart's) or other: what is left should be "
               "refused, and is not scored");
  group.count("vary", options.variants, variant_count,
              "run this many variants of every model beside it, of ten: shuffled, half of the vertices, noise, more "
              "samples, stretched, a third, fewer samples, mirrored, smoothed, subdivided; one table of variants",
              Default::Hidden);
  group.number("drop", disturbance.drop, "F", "drop this share of the points at random", Default::Hidden);
  group.count("holes", options.holes, 1024, "cut this many holes", Default::Hidden);
  group.number("hole-share", disturbance.hole_share, "F", "share of the points in all holes");
  group.number("thin", disturbance.thin, "R", "drop points in a random direction down to 1/R of the density",
               Default::Hidden);
  group.number("noise", disturbance.noise, "F", "move points, standard deviation over the bounding box's diagonal",
               Default::Hidden);
  group.number("quantise", disturbance.quantise, "F", "round coordinates to multiples of this share of the diagonal",
               Default::Hidden);
  group.number("bend", disturbance.bend, "A",
               "give models another pose: bend and twist space by this angle, in radians over the diagonal",
               Default::Hidden);
  group.number("repeat", disturbance.repeat, "F", "add this share of points that are there already", Default::Hidden);
  group.number("outliers", disturbance.outliers, "F", "add this share of points at random places", Default::Hidden);
  group.number("seed", options.seed, "S", "of the disturbance, any integer");
  return group;
}

void
checkCombination(const BenchmarkOptions& options)
{
  const bool scores_map = !options.scored_map.empty();
  if (scores_map != !options.score_mesh.empty() || scores_map != !options.score_truth.empty())
    throw UsageError("--score, --mesh and --truth belong together");
  if (scores_map && (!options.csv.empty() || !options.plot.empty()))
    throw UsageError("--score writes --json only, neither --csv nor --plot");
  if (scores_map && !options.folder.empty())
    throw UsageError("either DIR or --score");
  if (!options.evidence.empty() && (options.graph || !options.csv.empty() || !options.json.empty() ||
                                    !options.plot.empty() || !options.map_folder.empty()))
    throw UsageError("--evidence writes nothing else: it goes with no other output");
  if (!options.vertex_evidence.empty() && options.evidence.empty())
    throw UsageError("--vertex-evidence goes with --evidence");
  if (options.contenders && (options.evidence.empty() || !options.vertex_evidence.empty()))
    throw UsageError("--contenders goes with --evidence alone");
  if (options.graph && (options.run.as_cloud || !options.csv.empty() || !options.json.empty() ||
                        !options.plot.empty() || !options.map_folder.empty()))
    throw UsageError("--graph finds no maps: it goes with neither --as-cloud nor an output file");
  if (options.graph && options.run.cut_limb)
    throw UsageError("--graph needs whole models: it does not go with --cut-limb");
  if (options.variants > 0 && (options.graph || options.run.cut_limb))
    throw UsageError("--vary goes with neither --graph nor --cut-limb");
}

bool
writesFiles(const BenchmarkOptions& options)
{
  const std::vector<std::string> files = options.outputs();
  return !options.map_folder.empty() || !options.paper.empty() ||
         std::any_of(files.begin(), files.end(), [](const auto& file) { return !file.empty(); });
}

/** \brief Names are compared of models as they are. */
void
checkNamesCombination(const BenchmarkOptions& options)
{
  if (!options.exchanged.empty() && !options.names)
    throw UsageError("--exchanged goes with --side-names");
  if (options.names && (writesFiles(options) || options.graph || options.run.cut_limb || options.variants > 0 ||
                        !options.run.disturbance.changesNothing() || !options.scored_map.empty()))
    throw UsageError("--side-names is of the models as they are and writes nothing else: of all that changes models or "
                     "writes files it goes with --as-cloud only");
}

/** \brief Ablations are of the robust method and write nothing. */
void
checkAblationCombination(const BenchmarkOptions& options)
{
  if (options.ablation &&
      (writesFiles(options) || options.samples > 0 || options.graph || options.names || options.run.cut_limb ||
       options.variants > 0 || options.run.parameters.method != Method::Robust || !options.scored_map.empty()))
    throw UsageError("--ablation is of the robust method on whole models and writes nothing else: it goes with "
                     "--as-cloud and the disturbances only, not with --samples either");
}

void
checkPaperCombination(const BenchmarkOptions& options)
{
  if (options.paper.empty())
    return;
  const std::vector<std::string> files = options.outputs();
  if (!options.map_folder.empty() || std::any_of(files.begin(), files.end(), [](const auto& f) { return !f.empty(); }))
    throw UsageError("--paper writes nothing else: it goes with no other output");
  if (options.run.parameters.method != Method::Robust)
    throw UsageError("--paper runs both methods: it does not go with --method");
  if (!options.scored_map.empty() || options.graph || options.run.as_cloud || options.run.cut_limb ||
      options.variants > 0 || !options.run.disturbance.changesNothing())
    throw UsageError("--paper is of the models as they are: it goes with none of --score, --graph, --as-cloud, "
                     "--cut-limb, --vary and the disturbances");
}

} // namespace

CommandLine
describeOptions(BenchmarkOptions& options)
{
  OptionGroup selection("Models");
  selection.words("set", options.sets, "NAME", "only this data set (repeatable)");
  selection.words("class", options.classes, "NAME", "only this class (repeatable)");
  selection.flag("all", options.all, "also models without ground truth, which are run but not scored");

  OptionGroup output("Output");
  output.file("csv", options.csv, "write one line per model to this file");
  output.file("json", options.json, "write all figures to this file");
  output.file("evidence", options.evidence,
              "write all that is measured on every map of every interpretation to this .csv file, delivered or not, "
              "instead of the scores: what the confidence is calibrated with");
  output.file("vertex-evidence", options.vertex_evidence,
              "with --evidence: the same for every scored vertex, into another .csv file");
  output.flag("contenders", options.contenders,
              "with --evidence: of all refined maps of the first interpretation instead, among which one is chosen");
  output.file("plot", options.plot, "draw the geodesic error curves into this .svg file");
  output.folder("paper", options.paper,
                "run both methods and write tables and figures beside the published ones into this folder: paper.md");
  output.folder("map-dir", options.map_folder, "write each map as SET_MODEL.csv into this folder");
  output.flag("verbose", options.verbose, "seconds per step and properties of the map for each model");

  OptionGroup score("One existing map (instead of DIR)");
  score.file("score", options.scored_map, "score this map, lines vertex,partner");
  score.file("mesh", options.score_mesh, "surface that the map belongs to");
  score.file("truth", options.score_truth, "CLASS.pid, MODEL.vts:N.sym.info or a dense list, 1-based");

  CommandLine line(
      program, "pcl_symmetry_benchmark DIR [options]\n"
               "       pcl_symmetry_benchmark --score MAP.csv --mesh FILE --truth TRUTH [--json FILE]\n\n"
               "Finds the symmetry of every model of the data sets in DIR and compares it with the ground truth.\n");
  line.add(selection);
  line.add(methodOptions(options));
  line.add(disturbanceOptions(options));
  line.add(output);
  line.add(score);
  line.addLast(OptionGroup("General"));
  return line;
}

void
completeOptions(BenchmarkOptions& options, const CommandLine& line)
{
  if (options.scored_map.empty() || !line.words().empty())
    options.folder = line.onlyWord("DIR", "a folder with data sets");
  options.run.parameters.threads = options.threads.value_or(options.jobs == 1 ? 0 : 1);
  options.run.disturbance.holes = options.holes;
  options.run.disturbance.seed = static_cast<std::uint64_t>(options.seed);
  setSamples(options.run.parameters, options.samples);
  checkParameterOptions(options.run.parameters);
  checkUsage<pcl::BadArgumentException>([&options] { checkDisturbance(options.run.disturbance); });
  checkCombination(options);
  checkNamesCombination(options);
  checkAblationCombination(options);
  checkPaperCombination(options);
}

} // namespace symmetry
} // namespace pcl
