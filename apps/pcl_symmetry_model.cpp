/** \file
 * \brief pcl_symmetry_model: writes a synthetic body with its exact ground truth.
 */
#include "cli/command_line.h"
#include "cli/output_names.h"
#include "model/articulated_body.h"
#include "model/disturb.h"
#include "model/write_model.h"

#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>

using namespace pcl::symmetry;

namespace {

constexpr const char* program = "pcl_symmetry_model";

struct Options {
  std::string output;
  std::string truth;
  std::string body = "human";
  ModelParameters model;
  double noise = 0.0;
  std::size_t holes = 0;
  double hole_share = 0.1;
  double thin = 1.0;
  double drop = 0.0;
  double outliers = 0.0;
  bool no_faces = false;
  bool shuffle = false;
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

OptionGroup
disturbanceOptions(Options& options)
{
  OptionGroup group("Disturbance (in this order)");
  group.number("holes", options.holes, "N", "cut N holes");
  group.number("hole-share", options.hole_share, "F", "share of the vertices that the holes take together, up to 0.9");
  group.number("thin", options.thin, "R",
               "drop points in a random direction down to 1/R of the density; drops the faces; up to 1000");
  group.number("drop", options.drop, "F", "drop this share of the points at random; drops the faces");
  group.flag("no-faces", options.no_faces, "write a point cloud");
  group.number("noise", options.noise, "F",
               "move points by a random length of this standard deviation, over the diagonal of the bounding box");
  group.number("outliers", options.outliers, "F", "add this share of points that do not belong to the body");
  group.flag("shuffle", options.shuffle, "put the vertices into random order");
  return group;
}

CommandLine
describeOptions(Options& options)
{
  ModelParameters& model = options.model;
  OptionGroup body("Body");
  body.word("body", options.body, "NAME", bodyNames().c_str());
  body.number("vertices", model.vertices, "N", "number of vertices, 1000 to 4000000");
  body.number("bend", model.bend, "X",
              "strength of the pose: 0 is the rest pose, 1 uses the whole range of every joint; up to 1.5");
  body.number("seed", model.seed, "S", "of the pose and of all that is random below");

  OptionGroup triangles("Triangles");
  triangles.numberOrNothing("retriangulate", model.retriangulate, "F",
                            "share of the right half's edges that are flipped, so that the triangles of left and right "
                            "differ; --retriangulate=0 keeps them alike");
  triangles.number("jitter", model.jitter, "F",
                   "slide the right half's vertices by up to this many edge lengths, up to 0.4");
  triangles.number("uneven", model.density_ratio, "R",
                   "one end of the body has R times the vertices per area of the other, up to 100");

  OptionGroup general("General");
  general.file("truth", options.truth,
               "write the true partners, lines 'i s(i)' counted from 1; points without one are left out");
  general.flag("quiet,q", options.quiet, "print nothing");

  CommandLine line(program, "pcl_symmetry_model OUTPUT.{ply,off,obj,pcd} [options]\n\n"
                            "Grows an articulated body whose true mirror partners are known.\n");
  line.add(body);
  line.add(triangles);
  line.add(disturbanceOptions(options));
  line.addLast(general);
  return line;
}

/** \brief Everything after the body has been grown; each step has random numbers of its own. */
void
disturb(Model& model, const Options& options)
{
  const std::uint64_t seed = options.model.seed;
  cutHoles(model, options.holes, options.hole_share, seed + 1);
  if (options.thin != 1.0)
    thinOut(model, options.thin, seed + 2);
  if (options.drop != 0.0)
    dropPoints(model, options.drop, seed + 3);
  if (options.no_faces)
    dropFaces(model);
  if (options.noise != 0.0)
    addNoise(model, options.noise, seed + 4);
  if (options.outliers != 0.0)
    addOutliers(model, options.outliers, seed + 5);
  if (options.shuffle)
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
run(const Options& options)
{
  checkWritableFiles({options.output, options.truth});
  Model model = makeModel(options.model);
  disturb(model, options);
  if (model.surface.size() == 0)
    throw std::runtime_error("the disturbance leaves no point");
  writePlainSurface(options.output, model.surface);
  if (!options.truth.empty())
    writeTruth(options.truth, model.partners);
  if (!options.quiet)
    printSummary(options, model);
}

/** \brief Refuses wrong values before the work starts. */
void
checkOptions(Options& options)
{
  checkSurfaceFileName(options.output);
  checkDistinct({options.truth}, {options.output});
  options.model.body = bodyFromName(options.body);
  Model nothing;
  disturb(nothing, options);
}

int
runWith(Options& options, const CommandLine& line)
{
  options.output = line.onlyWord("OUTPUT", "a file");
  checkUsage<std::invalid_argument>([&options] {
    checkOptions(options);
    run(options);
  });
  return exit_done;
}

} // namespace

int
main(int argc, char** argv)
{
  return runCommand(program, argc, argv, describeOptions, runWith);
}
