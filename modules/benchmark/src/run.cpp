#include "benchmark/run.h"

#include "geodesic/parallel.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <exception>
#include <mutex>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

void
takeResult(ModelRun& run, SymmetryResult result)
{
  run.status = result.status;
  run.message = std::move(result.message);
  run.confidence = result.confidence;
  run.partners = std::move(result.partners);
  run.confidences = std::move(result.confidences);
  run.map = result.map;
  run.seconds = std::move(result.seconds);
}

void
runAndScore(ModelRun& run, const RunOptions& options)
{
  const Surface mesh = readSurface(run.model.file);
  run.points = mesh.size();
  run.faces = mesh.triangles.size();

  Surface input = mesh;
  if (options.as_cloud)
    input.triangles.clear();
  takeResult(run, estimateIntrinsicSymmetry(input, options.parameters));

  if (run.model.truth.empty())
    return;
  const GroundTruth truth = readGroundTruth(run.model.truth);
  checkGroundTruth(truth, mesh.size(), run.model.truth);
  run.score = scoreMap(mesh, truth, run.partners, options.parameters.threads);
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
    run.failure = error.what();
    run.score.reset();
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
