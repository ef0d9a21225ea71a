#include "benchmark/ablation.h"

#include "base/error_text.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "benchmark/metrics.h"
#include "benchmark/model_input.h"
#include "benchmark/summary.h"
#include "symmetry/rival_interpretations.h"

#include <chrono>
#include <exception>
#include <iomanip>
#include <ostream>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

void
runAblation(ModelRun& run,
            const ModelInput& input,
            const PreparedSurface& surface,
            const SymmetryParameters& parameters,
            const RobustSettings& settings)
{
  using Clock = std::chrono::steady_clock;
  StepTimer timer;
  const Clock::time_point start = Clock::now();
  const Interpretation interpretation{surface, estimateRobust(surface, parameters, settings, timer)};
  run.seconds = {{"estimation", std::chrono::duration<double>(Clock::now() - start).count()}};
  if (!input.asked.empty()) {
    run.score = scoreMap(input.mesh, input.asked, mapOfFile(input, mapOfInput(interpretation)));
  }
}

/** All ablations of one model. */
std::vector<ModelRun>
runAllOf(const BenchmarkModel& model, const std::vector<Ablation>& changes, const RunOptions& options)
{
  std::vector<ModelRun> runs(changes.size());
  for (ModelRun& run : runs) {
    run.model = model;
  }
  try {
    const ModelInput input = readModel(model, options);
    const SymmetryParameters parameters = parametersFor(model, options);
    const PreparedSurface surface = firstSurface(input, parameters);
    for (std::size_t k = 0; k < changes.size(); ++k) {
      runAblation(runs[k], input, surface, parameters, changes[k].settings);
    }
  }
  catch (const std::exception& error) {
    for (ModelRun& run : runs) {
      run.failure = errorText(error);
    }
  }
  return runs;
}

} // namespace

std::vector<Ablation>
ablations()
{
  std::vector<Ablation> changes{{"whole method", {}}};
  const auto with = [&changes](const char* name, auto change) {
    changes.push_back({name, {}});
    change(changes.back().settings);
  };
  with("no sign patterns", [](RobustSettings& s) { s.search.sign_patterns = false; });
  with("no pairings", [](RobustSettings& s) { s.search.pairings = 0; });
  with("no parts derived anew", [](RobustSettings& s) { s.search.rederived = 0; });
  with("no parts regrown", [](RobustSettings& s) { s.search.regrown = 0; });
  with("limbs not exchanged", [](RobustSettings& s) { s.exchange.exchanges = 0; });
  with("one candidate refined", [](RobustSettings& s) { s.contenders = 1; });
  with("no curvature in the score", [](RobustSettings& s) {
    s.search.score.curvature = 0.0F;
    s.refinement.score.curvature = 0.0F;
  });
  with("no local parts as guide", [](RobustSettings& s) {
    s.search.guidance = 0.0F;
    s.refinement.guidance = 0.0F;
  });
  with("large patches only", [](RobustSettings& s) { s.refinement.patches.resize(1); });
  with("small patches only", [](RobustSettings& s) { s.refinement.patches = {s.refinement.patches.back()}; });
  with("fit of patches not compared", [](RobustSettings& s) { s.refinement.fit = 0.0F; });
  with("median turn not compared", [](RobustSettings& s) { s.refinement.median_turn = 0.0F; });
  with("displacement not compared", [](RobustSettings& s) { s.refinement.displacement = 0.0F; });
  with("moved ends not compared", [](RobustSettings& s) {
    s.refinement.moved_ends = 0.0F;
    s.refinement.moved_ends_of_candidates = 0.0F;
  });
  with("extremities not turned", [](RobustSettings& s) { s.refinement.extremity_radii.clear(); });
  with("reflections do not spread", [](RobustSettings& s) { s.refinement.growth.patches = 0; });
  with("not drawn to an involution", [](RobustSettings& s) { s.refinement.mutual_rounds = 0; });
  with("half of the samples", [](RobustSettings& s) { s.sampling.samples /= 2; });
  with("twice the samples", [](RobustSettings& s) { s.sampling.samples *= 2; });
  with("half of the landmarks", [](RobustSettings& s) { s.sampling.landmarks /= 2; });
  return changes;
}

std::vector<std::vector<ModelRun>>
runAblations(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs)
{
  const std::vector<Ablation> changes = ablations();
  std::vector<std::vector<ModelRun>> of_models(models.size());
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
    of_models[i] = runAllOf(models[i], changes, options);
  });
  std::vector<std::vector<ModelRun>> runs(changes.size());
  for (std::vector<ModelRun>& of_model : of_models) {
    for (std::size_t k = 0; k < changes.size(); ++k) {
      runs[k].push_back(std::move(of_model[k]));
    }
  }
  return runs;
}

void
printAblations(std::ostream& out, const std::vector<std::vector<ModelRun>>& runs)
{
  constexpr int name_width = 28;
  const std::vector<Ablation> changes = ablations();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::vector<GroupSummary> sets = summariseSets(summariseClasses(runs[k]));
    std::vector<double> times;
    for (std::size_t i = 0; i < runs[k].size(); ++i) {
      if (runs[0][i].totalSeconds() > 0.0) {
        times.push_back(runs[k][i].totalSeconds() / runs[0][i].totalSeconds());
      }
    }
    if (k == 0) {
      out << std::left << std::setw(name_width) << "rate / Mesh Rate" << std::right;
      for (const GroupSummary& set : sets) {
        out << std::setw(14) << set.set;
      }
      out << std::setw(8) << "time" << '\n';
    }
    out << std::left << std::setw(name_width) << changes[k].name << std::right << std::fixed << std::setprecision(1);
    for (const GroupSummary& set : sets) {
      out << std::setw(7) << 100.0 * set.correspondence_rate << " /" << std::setw(5) << 100.0 * set.mesh_rate;
    }
    out << std::setprecision(2) << std::setw(8) << (times.empty() ? 0.0 : median(times)) << '\n';
  }
}

} // namespace symmetry
} // namespace pcl
