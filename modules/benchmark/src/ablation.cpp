#include "benchmark/ablation.h"

#include "../../estimation/src/neighbour_search.h"
#include "base/error_text.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "benchmark/interpretation_map.h"
#include "benchmark/metrics.h"
#include "benchmark/model_input.h"
#include "symmetry/interpretations.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iomanip>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief The accuracy of the models of one set. */
struct SetAccuracy {
  std::map<std::string, std::vector<double>> rates_of_class;

  /** The mean over the classes of the mean of some figure of each rate. */
  template <typename Figure>
  double
  meanOfClasses(Figure figure) const
  {
    double sum = 0.0;
    for (const auto& [name, rates] : rates_of_class) {
      double of_class = 0.0;
      for (const double rate : rates) {
        of_class += figure(rate);
      }
      sum += of_class / static_cast<double>(rates.size());
    }
    return sum / static_cast<double>(rates_of_class.size());
  }
};

AblationRun
runAblation(const BenchmarkModel& model,
            const ModelInput& input,
            const PreparedSurface& surface,
            const SymmetryParameters& parameters,
            const RobustSettings& settings)
{
  using Clock = std::chrono::steady_clock;
  AblationRun run;
  run.model = model;
  StepTimer timer;
  const Clock::time_point start = Clock::now();
  Interpretation interpretation{surface, estimateRobust(surface, parameters, settings, timer)};
  run.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!interpretation.estimate.partners.empty()) {
    run.rate = scoreMap(input.mesh, input.asked, mapOfModel(interpretation, input)).correspondenceRate();
  }
  return run;
}

/** All ablations of one model. */
std::vector<AblationRun>
runAllOf(const BenchmarkModel& model, const std::vector<Ablation>& changes, const RunOptions& options)
{
  const ModelInput input = readModel(model, options);
  const SymmetryParameters parameters = parametersFor(model, options);
  const NeighbourSearch search = searchByKdTree;
  InterpretationPlan plan(input.input.surface, parameters, search);
  const std::optional<InterpretationPlan::Attempt> first = plan.next(RivalInterpretations(plan.pooling()));
  std::vector<AblationRun> runs;
  runs.reserve(changes.size());
  for (const Ablation& change : changes) {
    runs.push_back(runAblation(model, input, first->surface, parameters, change.settings));
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
  with("extremities not turned", [](RobustSettings& s) { s.refinement.extremity_radii.clear(); });
  with("reflections do not spread", [](RobustSettings& s) { s.refinement.growth.patches = 0; });
  with("not drawn to an involution", [](RobustSettings& s) { s.refinement.mutual_rounds = 0; });
  with("half of the samples", [](RobustSettings& s) { s.sampling.samples /= 2; });
  with("twice the samples", [](RobustSettings& s) { s.sampling.samples *= 2; });
  with("half of the landmarks", [](RobustSettings& s) { s.sampling.landmarks /= 2; });
  return changes;
}

std::vector<std::vector<AblationRun>>
runAblations(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs, std::ostream& errors)
{
  const std::vector<Ablation> changes = ablations();
  std::vector<std::vector<AblationRun>> of_models(models.size());
  std::vector<std::string> failures(models.size());
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
    try {
      of_models[i] = runAllOf(models[i], changes, options);
    }
    catch (const std::exception& error) {
      failures[i] = errorText(error);
    }
  });
  std::vector<std::vector<AblationRun>> runs(changes.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!failures[i].empty()) {
      errors << models[i].set << '/' << models[i].name << ": " << failures[i] << '\n';
      continue;
    }
    for (std::size_t k = 0; k < changes.size(); ++k) {
      runs[k].push_back(std::move(of_models[i][k]));
    }
  }
  return runs;
}

void
printAblations(std::ostream& out, const std::vector<std::vector<AblationRun>>& runs)
{
  constexpr double right = 0.75; // Correspondence Rate above which a mesh counts as mapped (Mesh Rate)
  constexpr int name_width = 28;
  const std::vector<Ablation> changes = ablations();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::map<std::string, SetAccuracy> sets;
    std::vector<double> times;
    for (std::size_t i = 0; i < runs[k].size(); ++i) {
      const AblationRun& run = runs[k][i];
      sets[run.model.set].rates_of_class[run.model.class_name].push_back(100.0 * run.rate);
      times.push_back(run.seconds / std::max(runs[0][i].seconds, 1e-9));
    }
    if (k == 0) {
      out << std::left << std::setw(name_width) << "rate / Mesh Rate" << std::right;
      for (const auto& [name, accuracy] : sets) {
        out << std::setw(14) << name;
      }
      out << std::setw(8) << "time" << '\n';
    }
    out << std::left << std::setw(name_width) << changes[k].name << std::right << std::fixed << std::setprecision(1);
    for (const auto& [name, accuracy] : sets) {
      const double mesh_rate = accuracy.meanOfClasses([](double rate) { return rate > 100.0 * right ? 100.0 : 0.0; });
      out << std::setw(7) << accuracy.meanOfClasses([](double rate) { return rate; }) << " /" << std::setw(5)
          << mesh_rate;
    }
    out << std::setprecision(2) << std::setw(8) << (times.empty() ? 0.0 : median(times)) << '\n';
  }
}

} // namespace symmetry
} // namespace pcl
