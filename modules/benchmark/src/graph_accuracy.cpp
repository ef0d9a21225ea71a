#include "benchmark/graph_accuracy.h"

#include "../../estimation/src/neighbour_search.h"
#include "base/error_text.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/pipeline.h"

#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <ostream>

namespace pcl {
namespace symmetry {
namespace {

/** A point in both graphs. */
struct CommonPoint {
  Index vertex; ///< of the mesh
  Index point;  ///< of the prepared surface
};

std::vector<CommonPoint>
commonPoints(const PreparedSurface& prepared, const std::vector<Index>& origins)
{
  std::vector<CommonPoint> common;
  for (std::size_t i = 0; i < origins.size(); ++i)
    if (origins[i] != no_index && prepared.representatives[i] != no_index)
      common.push_back({origins[i], prepared.representatives[i]});
  return common;
}

/** At most so many entries, evenly numbered. */
std::vector<CommonPoint>
thinned(const std::vector<CommonPoint>& all, std::size_t maximum)
{
  std::vector<CommonPoint> some;
  const std::size_t step = (all.size() + maximum - 1) / maximum;
  for (std::size_t i = 0; i < all.size(); i += step)
    some.push_back(all[i]);
  return some;
}

void
compareModel(GraphRun& run, const RunOptions& options)
{
  const Surface mesh = readSurface(run.model.file);
  if (!mesh.hasFaces())
    throw pcl::IOException(run.model.file + ": there are no faces to measure distances on");
  DisturbedSurface input = disturb(mesh, options.disturbance);
  input.surface.triangles.clear();
  StepTimer timer;
  InputSummary summary;
  const Interpretation interpretation =
      interpretSurface(input.surface, options.parameters, searchByKdTree, timer, summary);
  run.accuracy = compareGraph(mesh, interpretation.surface, input.origins);
}

void
printLine(std::ostream& out, const std::string& name, double median_error, double short_pairs)
{
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%-40s %9.2f %9.2f\n", name.c_str(), 100.0 * median_error,
                100.0 * short_pairs);
  out << line.data();
}

/** Sums of the figures of a group. */
struct Totals {
  double median_error = 0.0;
  double short_pairs = 0.0;
  double count = 0.0;

  void
  add(double error, double share)
  {
    median_error += error;
    short_pairs += share;
    count += 1.0;
  }
};

} // namespace

GraphAccuracy
compareGraph(const Surface& mesh, const PreparedSurface& prepared, const std::vector<Index>& origins)
{
  constexpr std::size_t maximum_sources = 100;
  constexpr std::size_t maximum_targets = 1000;
  constexpr double nearest = 0.05;
  constexpr double shortened = 0.8;
  const std::vector<CommonPoint> common = commonPoints(prepared, origins);
  const std::vector<CommonPoint> sources = thinned(common, maximum_sources);
  const std::vector<CommonPoint> targets = thinned(common, maximum_targets);
  std::vector<Index> vertices;
  std::vector<Index> points;
  for (const CommonPoint& source : sources) {
    vertices.push_back(source.vertex);
    points.push_back(source.point);
  }
  const SurfaceGraph mesh_graph = buildMeshGraph(mesh.points, mesh.triangles);
  const DistanceFields along_mesh = distanceFields(mesh_graph, vertices);
  const DistanceFields along_cloud = distanceFields(prepared.graph, points);
  double diameter = 0.0;
  for (const float distance : along_mesh.values)
    if (std::isfinite(distance))
      diameter = std::max(diameter, double{distance});

  GraphAccuracy accuracy;
  std::vector<double> errors;
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (const CommonPoint& target : targets) {
      const double truth = along_mesh.row(i)[target.vertex];
      const double distance = double{along_cloud.row(i)[target.point]} / double{prepared.scale};
      if (!std::isfinite(truth) || truth < nearest * diameter)
        continue;
      errors.push_back(std::abs(distance - truth) / truth);
      accuracy.short_pairs += distance < shortened * truth ? 1.0 : 0.0;
    }
  accuracy.pairs = errors.size();
  if (!errors.empty()) {
    accuracy.short_pairs /= static_cast<double>(errors.size());
    accuracy.median_error = median(std::move(errors));
  }
  return accuracy;
}

std::vector<GraphRun>
compareGraphs(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs)
{
  std::vector<GraphRun> runs(models.size());
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
    runs[i].model = models[i];
    try {
      compareModel(runs[i], options);
    }
    catch (const std::exception& error) {
      runs[i].failure = errorText(error);
    }
  });
  return runs;
}

void
printGraphs(std::ostream& out, const std::vector<GraphRun>& runs)
{
  out << "cloud against mesh                          error %   short %\n";
  std::map<std::string, std::map<std::string, Totals>> sets;
  for (const GraphRun& run : runs) {
    if (!run.failure.empty()) {
      out << run.model.set << '/' << run.model.name << "  failed: " << run.failure << '\n';
      continue;
    }
    printLine(out, run.model.set + "/" + run.model.name, run.accuracy.median_error, run.accuracy.short_pairs);
    sets[run.model.set][run.model.class_name].add(run.accuracy.median_error, run.accuracy.short_pairs);
  }
  for (const auto& [set, classes] : sets) {
    const std::string prefix = set + "/";
    Totals whole;
    out << '\n';
    for (const auto& [name, totals] : classes) {
      whole.add(totals.median_error / totals.count, totals.short_pairs / totals.count);
      printLine(out, prefix + name, totals.median_error / totals.count, totals.short_pairs / totals.count);
    }
    printLine(out, set + " (mean of classes)", whole.median_error / whole.count, whole.short_pairs / whole.count);
  }
}

} // namespace symmetry
} // namespace pcl
