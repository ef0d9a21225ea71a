#include "benchmark/run.h"

#include "base/error_text.h"
#include "base/parallel.h"
#include "benchmark/model_input.h"

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
takeResult(ModelRun& run, SymmetryResult result, const ModelInput& model)
{
  const std::vector<Index>& origins = model.input.origins;
  run.status = result.status;
  run.message = std::move(result.message);
  run.confidence = result.confidence;
  run.map = result.map;
  run.seconds = std::move(result.seconds);
  run.partners = mapOfFile(model, result.partners);
  run.confidences.assign(run.points, 0.0F);
  for (std::size_t i = 0; i < result.confidences.size(); ++i)
    if (origins[i] != no_index)
      run.confidences[static_cast<std::size_t>(origins[i])] = result.confidences[i];
}

void
runAndScore(ModelRun& run, const RunOptions& options)
{
  const ModelInput model = readModel(run.model, options);
  run.points = model.mesh.size();
  run.faces = model.mesh.triangles.size();
  takeResult(run, estimateIntrinsicSymmetry(model.input.surface, parametersFor(run.model, options)), model);
  if (!model.asked.empty() && !options.cut_limb) {
    run.score = scoreMap(model.mesh, model.asked, run.partners, options.parameters.threads);
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
