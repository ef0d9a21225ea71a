#include "benchmark/run.h"

#include "base/error_text.h"
#include "base/parallel.h"
#include "base/vector_math.h"
#include "benchmark/model_input.h"

#include <pcl/symmetry/symmetry.h>

#include <algorithm>
#include <exception>
#include <limits>
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
  run.unsupported = std::move(result.unsupported);
  run.seconds = std::move(result.seconds);
  run.partners = mapOfFile(model, result.partners);
  run.confidences.assign(run.points, 0.0F);
  for (std::size_t i = 0; i < result.confidences.size(); ++i)
    if (origins[i] != no_index)
      run.confidences[static_cast<std::size_t>(origins[i])] = result.confidences[i];
}

/** Share of the area that is left around the vertices of known truth whose partner is cut off; a third of every face
 * counts for each of its corners. A cloud has no faces: there every point counts alike. */
double
oddShare(const ModelInput& model, const std::vector<VertexTruth>& truth)
{
  const Surface& left = model.input.surface;
  double known = 0.0;
  double odd = 0.0;
  const auto add = [&](Index v, double area) {
    const Index origin = model.input.origins[static_cast<std::size_t>(v)];
    const VertexTruth of_vertex = origin == no_index ? VertexTruth::Unknown : truth[static_cast<std::size_t>(origin)];
    known += of_vertex == VertexTruth::Unknown ? 0.0 : area;
    odd += of_vertex == VertexTruth::Odd ? area : 0.0;
  };
  for (const Triangle& t : left.triangles) {
    const Vector3& a = left.points[static_cast<std::size_t>(t[0])];
    const float area =
        norm(cross(left.points[static_cast<std::size_t>(t[1])] - a, left.points[static_cast<std::size_t>(t[2])] - a));
    for (const Index v : t)
      add(v, static_cast<double>(area));
  }
  for (std::size_t v = 0; left.triangles.empty() && v < left.size(); ++v)
    add(static_cast<Index>(v), 1.0);
  return known > 0.0 ? odd / known : 0.0;
}

/** What is known of the vertex nearest to a point of the input of which something is. */
VertexTruth
truthNear(const ModelInput& model, const std::vector<VertexTruth>& truth, Index point)
{
  const Vector3& place = model.input.surface.points[static_cast<std::size_t>(point)];
  VertexTruth nearest = VertexTruth::Unknown;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const float apart = distance(place, model.mesh.points[v]);
    if (truth[v] != VertexTruth::Unknown && apart < least) {
      least = apart;
      nearest = truth[v];
    }
  }
  return nearest;
}

OddPartAccuracy
scoreOddPart(const ModelRun& run, const ModelInput& model)
{
  const std::vector<VertexTruth> truth = vertexTruths(run.model, model);
  OddPartAccuracy accuracy;
  accuracy.true_share = oddShare(model, truth);
  for (const UnsupportedPart& part : run.unsupported)
    if (truthNear(model, truth, part.extreme) == VertexTruth::Odd)
      accuracy.found_share += static_cast<double>(part.share);
  accuracy.rest_rate = scoreMap(model.mesh, model.asked, run.partners).correspondenceRate();
  return accuracy;
}

void
runAndScore(ModelRun& run, const RunOptions& options)
{
  const ModelInput model = readModel(run.model, options);
  run.points = model.mesh.size();
  run.faces = model.mesh.triangles.size();
  takeResult(run, estimateIntrinsicSymmetry(model.input.surface, parametersFor(run.model, options)), model);
  if (!model.asked.empty() && !options.cut_limb) {
    run.score = scoreMap(model.mesh, model.asked, run.partners);
  }
  if (!model.asked.empty() && options.cut_limb && hasMap(run.status)) {
    run.odd_part = scoreOddPart(run, model);
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
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
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
