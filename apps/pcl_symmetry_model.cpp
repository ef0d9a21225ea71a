/** \file
 * \brief pcl_symmetry_model: writes a synthetic body with its exact ground truth.
 */
#include "base/error_text.h"
#include "io/write/output_file.h"
#include "model/articulated_body.h"
#include "model/disturb.h"
#include "model/write_model.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace po = boost::program_options;
using namespace pcl::symmetry;

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

struct Options {
  std::string output;
  std::string truth;
  std::string body;
  ModelParameters model;
  double noise = 0.0;
  std::size_t holes = 0;
  double hole_share = 0.0;
  double thin = 1.0;
  double drop = 0.0;
  double outliers = 0.0;
  bool quiet = false;
};

std::string
bodyNames()
{
  std::string names;
  for (const Body body : allBodies())
    names += (names.empty() ? "" : ", ") + std::string(toString(body));
  return names;
}

po::options_description
describeOptions(Options& options)
{
  ModelParameters& model = options.model;
  po::options_description body("Body");
  auto add_body = body.add_options();
  add_body("body", po::value(&options.body)->default_value("human")->value_name("NAME"), bodyNames().c_str());
  add_body("vertices", po::value(&model.vertices)->default_value(model.vertices)->value_name("N"),
           "number of vertices, 1000 to 4000000");
  add_body("bend", po::value(&model.bend)->default_value(model.bend)->value_name("X"),
           "strength of the pose: 0 is the rest pose, 1 uses the whole range of every joint; up to 1.5");
  add_body("seed", po::value(&model.seed)->default_value(model.seed)->value_name("S"),
           "of the pose and of all that is random below");
  po::options_description triangles("Triangles");
  auto add_triangles = triangles.add_options();
  add_triangles("retriangulate",
                po::value(&model.retriangulate)
                    ->default_value(model.retriangulate, "0.3")
                    ->implicit_value(model.retriangulate, "0.3")
                    ->value_name("F"),
                "share of the right half's edges that are flipped, so that the triangles of left and right differ; "
                "--retriangulate=0 keeps them alike");
  add_triangles("jitter", po::value(&model.jitter)->default_value(model.jitter)->value_name("F"),
                "slide the right half's vertices by up to this many edge lengths, up to 0.4");
  add_triangles("uneven", po::value(&model.density_ratio)->default_value(model.density_ratio)->value_name("R"),
                "one end of the body has R times the vertices per area of the other, up to 100");
  po::options_description disturbance("Disturbance (in this order)");
  auto add = disturbance.add_options();
  add("holes", po::value(&options.holes)->default_value(0)->value_name("N"), "cut N holes");
  add("hole-share", po::value(&options.hole_share)->default_value(0.1, "0.1")->value_name("F"),
      "share of the vertices that the holes take together, up to 0.9");
  add("thin", po::value(&options.thin)->default_value(1.0)->value_name("R"),
      "drop points in a random direction down to 1/R of the density; drops the faces; up to 1000");
  add("drop", po::value(&options.drop)->default_value(0.0)->value_name("F"),
      "drop this share of the points at random; drops the faces");
  add("no-faces", "write a point cloud");
  add("noise", po::value(&options.noise)->default_value(0.0)->value_name("F"),
      "move points by a random length of this standard deviation, over the diagonal of the bounding box");
  add("outliers", po::value(&options.outliers)->default_value(0.0)->value_name("F"),
      "add this share of points that do not belong to the body");
  add("shuffle", "put the vertices into random order");
  po::options_description general("General");
  general.add_options()("truth", po::value(&options.truth)->value_name("FILE"),
                        "write the true partners, lines 'i s(i)' counted from 1; points without one are left out")(
      "quiet,q", "print nothing")("help,h", "print this text")("version", "print the version");
  po::options_description visible;
  return visible.add(body).add(triangles).add(disturbance).add(general);
}

po::variables_map
parse(int argc, const char* const* argv, const po::options_description& visible, Options& options)
{
  po::options_description all;
  all.add(visible).add_options()("output", po::value(&options.output));
  po::positional_options_description positional;
  positional.add("output", 1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
                .run(),
            values);
  po::notify(values);
  return values;
}

/** \brief A minus sign before an unsigned number wraps around silently: such words are refused. */
void
refuseNegativeNumbers(int argc, const char* const* argv)
{
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::size_t value = word.rfind("--", 0) == 0 ? word.find('=') + 1 : 0; // 0 when there is no '='
    if (word.size() > value + 1 && word[value] == '-' && word.find_first_of("0123456789", value) == value + 1)
      throw std::invalid_argument("'" + word + "': no value may be negative");
  }
}

/** \brief Everything after the body has been grown; each step has random numbers of its own. */
void
disturb(Model& model, const Options& options, const po::variables_map& values)
{
  const std::uint64_t seed = options.model.seed;
  cutHoles(model, options.holes, options.hole_share, seed + 1);
  if (options.thin != 1.0)
    thinOut(model, options.thin, seed + 2);
  if (options.drop != 0.0)
    dropPoints(model, options.drop, seed + 3);
  if (values.count("no-faces") != 0)
    dropFaces(model);
  if (options.noise != 0.0)
    addNoise(model, options.noise, seed + 4);
  if (options.outliers != 0.0)
    addOutliers(model, options.outliers, seed + 5);
  if (values.count("shuffle") != 0)
    shuffleVertices(model, seed + 6);
}

void
printSummary(const Options& options, const Model& model)
{
  std::size_t pairs = 0;
  std::size_t axis = 0;
  for (std::size_t i = 0; i < model.partners.size(); ++i) {
    pairs += model.partners[i] > static_cast<Index>(i) ? 1 : 0;
    axis += model.partners[i] == static_cast<Index>(i) ? 1 : 0;
  }
  std::cout << options.output << ": " << options.body << ", " << model.surface.size() << " vertices, "
            << model.surface.triangles.size() << " triangles, " << pairs << " pairs, " << axis << " on the axis\n";
}

void
run(const Options& options, const po::variables_map& values)
{
  Model nothing;
  disturb(nothing, options, values); // refuses wrong values before the work starts
  for (const std::string& file : {options.output, options.truth})
    if (!file.empty())
      checkOutputFile(file);
  Model model = makeModel(options.model);
  disturb(model, options, values);
  if (model.surface.size() == 0)
    throw std::runtime_error("the disturbance leaves no point");
  writePlainSurface(options.output, model.surface);
  if (!options.truth.empty())
    writeTruth(options.truth, model.partners);
  if (values.count("quiet") == 0)
    printSummary(options, model);
  if (!std::cout.flush())
    throw std::runtime_error("standard output: cannot be written");
}

int
usageError(const std::string& reason)
{
  std::cerr << "pcl_symmetry_model: " << reason << "\nTry 'pcl_symmetry_model --help'.\n";
  return exit_usage;
}

} // namespace

int
main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error with a message
  try {
    Options options;
    const po::options_description visible = describeOptions(options);
    refuseNegativeNumbers(argc, argv);
    const po::variables_map values = parse(argc, argv, visible, options);
    if (values.count("help") != 0) {
      std::cout << "usage: pcl_symmetry_model OUTPUT.{ply,off,obj,pcd} [options]\n\n"
                << "Grows an articulated body whose true mirror partners are known.\n"
                << visible;
      return exit_done;
    }
    if (values.count("version") != 0) {
      std::cout << "pcl_symmetry_model " << PCL_SYMMETRY_VERSION << '\n';
      return exit_done;
    }
    if (options.output.empty())
      return usageError("no output file is named");
    checkSurfaceFileName(options.output);
    if (values.count("truth") != 0 && options.truth.empty())
      return usageError("--truth needs the name of a file");
    if (areOneFile(options.output, options.truth))
      return usageError("'" + options.truth + "' would be overwritten: each file needs a name of its own");
    options.model.body = bodyFromName(options.body);
    run(options, values);
    return exit_done;
  }
  catch (const po::error& error) {
    return usageError(error.what());
  }
  catch (const std::invalid_argument& error) {
    return usageError(error.what());
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_symmetry_model: " << errorText(error) << '\n';
    return exit_failed;
  }
}
