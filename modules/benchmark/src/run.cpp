#include "benchmark/run.h"

#include "base/error_text.h"
#include "base/parallel.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Takes over the result, with the per-point parts in the numbering of the file. */
void
takeResult(ModelRun& run, SymmetryResult result, const std::vector<Index>& origins)
{
  run.status = result.status;
  run.message = std::move(result.message);
  run.confidence = result.confidence;
  run.map = result.map;
  run.seconds = std::move(result.seconds);
  run.partners = undisturbMap(result.partners, origins, run.points);
  run.confidences.assign(run.points, 0.0F);
  for (std::size_t i = 0; i < result.confidences.size(); ++i)
    if (origins[i] != no_index)
      run.confidences[static_cast<std::size_t>(origins[i])] = result.confidences[i];
}

/** The part of the ground truth that is scored: a point that was dropped is nothing the estimation was asked about.
 * \param[in] with_partner nor is one whose partner is gone; where single points were dropped, one next to it will do */
GroundTruth
selectTruth(const GroundTruth& truth, const std::vector<Index>& origins, std::size_t points, bool with_partner)
{
  std::vector<bool> is_present(points, false);
  for (const Index origin : origins)
    if (origin != no_index)
      is_present[static_cast<std::size_t>(origin)] = true;
  const auto is_asked = [&](const TruePartner& p) {
    return is_present[static_cast<std::size_t>(p.vertex)] &&
           (!with_partner || is_present[static_cast<std::size_t>(p.partner)]);
  };
  GroundTruth selected = subsampleTruth(truth);
  selected.erase(std::remove_if(selected.begin(), selected.end(), [&](const TruePartner& p) { return !is_asked(p); }),
                 selected.end());
  return selected;
}

/** The mesh as it is given to the estimation. */
DisturbedSurface
prepareInput(const Surface& mesh, const GroundTruth& truth, const RunOptions& options)
{
  if (!options.cut_limb)
    return disturb(mesh, options.disturbance);
  const DisturbedSurface rest = cutLimb(mesh, truth, *options.cut_limb, options.as_cloud ? Stump::Open : Stump::Closed);
  DisturbedSurface input = disturb(rest.surface, options.disturbance);
  for (Index& origin : input.origins)
    if (origin != no_index)
      origin = rest.origins[static_cast<std::size_t>(origin)];
  return input;
}

void
runAndScore(ModelRun& run, const RunOptions& options)
{
  const Surface mesh = readSurface(run.model.file);
  run.points = mesh.size();
  run.faces = mesh.triangles.size();
  GroundTruth truth;
  if (!run.model.truth.empty()) {
    truth = readGroundTruth(run.model.truth);
    checkGroundTruth(truth, mesh.size(), run.model.truth);
  }

  DisturbedSurface input = prepareInput(mesh, truth, options);
  if (options.as_cloud)
    input.surface.triangles.clear();
  takeResult(run, estimateIntrinsicSymmetry(input.surface, options.parameters), input.origins);
  if (!truth.empty() && !options.cut_limb) {
    const GroundTruth asked = selectTruth(truth, input.origins, mesh.size(), options.disturbance.holes > 0);
    run.score = scoreMap(mesh, asked, run.partners, options.parameters.threads);
  }
}

} // namespace

double
ModelRun::totalSeconds() const
{
  double total = 0.0;
  for (const auto& step : seconds)
    total += step.second;
  return total;
}

ModelRun
runModel(const BenchmarkModel& model, const RunOptions& options)
{
  ModelRun run;
  run.model = model;
  try {
    runAndScore(run, options);
  }
  catch (const std::exception& error) {
    run.failure = errorText(error);
  }
  return run;
}

std::vector<ModelRun>
runModels(const std::vector<BenchmarkModel>& models,
          const RunOptions& options,
          unsigned jobs,
          const std::function<void(const ModelRun&)>& finished)
{
  std::vector<ModelRun> runs(models.size());
  std::vector<bool> is_done(models.size(), false);
  std::size_t reported = 0;
  std::mutex mutex;
  parallelFor(models.size(), jobs, [&](std::size_t i) {
    ModelRun run = runModel(models[i], options);
    const std::lock_guard<std::mutex> lock(mutex);
    runs[i] = std::move(run);
    is_done[i] = true;
    for (; reported < runs.size() && is_done[reported]; ++reported)
      if (finished)
        finished(runs[reported]);
  });
  return runs;
}

} // namespace symmetry
} // namespace pcl
