#include "benchmark/summary.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

bool
isScored(const ModelRun& run)
{
  return run.score || (!run.model.truth.empty() && !run.failure.empty());
}

double
shareBelow(const ModelRun& run, double threshold)
{
  return run.score ? run.score->shareBelow(threshold) : 0.0;
}

GroupSummary
summariseRun(const ModelRun& run)
{
  GroupSummary summary;
  summary.set = run.model.set;
  summary.class_name = run.model.class_name;
  summary.models = 1;
  summary.failed = run.failure.empty() ? 0 : 1;
  summary.symmetric = run.failure.empty() && hasMap(run.status) ? 1 : 0;
  summary.correspondence_rate = run.correspondenceRate();
  summary.mesh_rate = run.score && run.score->isRight() ? 1.0 : 0.0;
  summary.mean_geodesic_error = run.score ? run.score->meanGeodesicError() : 1.0;
  for (std::size_t i = 0; i < error_thresholds.size(); ++i)
    summary.below[i] = shareBelow(run, error_thresholds[i]);
  summary.mean_confidence = run.confidence;
  summary.mean_seconds = run.totalSeconds();
  return summary;
}

/** Mean of the figures and sum of the counts; all members have the same weight. */
GroupSummary
average(const std::vector<GroupSummary>& members)
{
  GroupSummary result;
  result.set = members.front().set;
  const double weight = 1.0 / static_cast<double>(members.size());
  for (const GroupSummary& member : members) {
    result.models += member.models;
    result.failed += member.failed;
    result.symmetric += member.symmetric;
    result.correspondence_rate += weight * member.correspondence_rate;
    result.mesh_rate += weight * member.mesh_rate;
    result.mean_geodesic_error += weight * member.mean_geodesic_error;
    for (std::size_t i = 0; i < result.below.size(); ++i)
      result.below[i] += weight * member.below[i];
    result.mean_confidence += weight * member.mean_confidence;
    result.mean_seconds += weight * member.mean_seconds;
  }
  return result;
}

template <typename Member, typename Value>
double
mean(const std::vector<Member>& members, Value value)
{
  double sum = 0.0;
  for (const Member& member : members)
    sum += value(member);
  return sum / static_cast<double>(members.size());
}

/** Members that share a key, groups in the order in which their keys first occur. */
template <typename Member, typename Key>
std::vector<std::vector<Member>>
groupBy(const std::vector<Member>& members, Key key)
{
  std::vector<std::vector<Member>> groups;
  for (const Member& member : members) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& other) { return key(other.front()) == key(member); });
    if (group == groups.end())
      groups.push_back({member});
    else
      group->push_back(member);
  }
  return groups;
}

} // namespace

std::vector<GroupSummary>
summariseClasses(const std::vector<ModelRun>& runs)
{
  std::vector<GroupSummary> models;
  for (const ModelRun& run : runs)
    if (isScored(run))
      models.push_back(summariseRun(run));
  std::vector<GroupSummary> classes;
  for (const auto& group : groupBy(models, [](const GroupSummary& m) { return std::make_pair(m.set, m.class_name); })) {
    classes.push_back(average(group));
    classes.back().class_name = group.front().class_name;
  }
  return classes;
}

std::vector<GroupSummary>
summariseSets(const std::vector<GroupSummary>& classes)
{
  std::vector<GroupSummary> sets;
  for (const auto& group : groupBy(classes, [](const GroupSummary& c) { return c.set; }))
    sets.push_back(average(group));
  return sets;
}

std::vector<VariantSummary>
summariseVariants(const std::vector<ModelRun>& runs)
{
  enum class Outcome : char { Refused, Wrong, Right };
  const auto outcome_of = [](const ModelRun& run) {
    return !hasMap(run.status) ? Outcome::Refused : run.score->isRight() ? Outcome::Right : Outcome::Wrong;
  };
  std::vector<VariantSummary> summaries;
  const ModelRun* as_it_is = nullptr;
  for (const ModelRun& run : runs) {
    if (run.model.variant == Variant::AsItIs)
      as_it_is = &run;
    if (!isScored(run) || !run.failure.empty())
      continue;
    auto place = std::find_if(summaries.begin(), summaries.end(), [&run](const VariantSummary& summary) {
      return summary.set == run.model.set && summary.variant == run.model.variant;
    });
    if (place == summaries.end())
      place = summaries.insert(summaries.end(), {run.model.set, run.model.variant});
    const Outcome outcome = outcome_of(run);
    ++place->models;
    place->refused += outcome == Outcome::Refused ? 1U : 0U;
    place->right += outcome == Outcome::Right ? 1U : 0U;
    place->sure_but_wrong += outcome == Outcome::Wrong && run.confidence > 0.5F ? 1U : 0U;
    place->alike += as_it_is != nullptr && outcome == outcome_of(*as_it_is) ? 1U : 0U;
    place->correspondence_rate += run.correspondenceRate();
  }
  for (VariantSummary& summary : summaries)
    summary.correspondence_rate /= static_cast<double>(summary.models);
  return summaries;
}

std::vector<ErrorCurve>
errorCurves(const std::vector<ModelRun>& runs, double largest, int steps)
{
  std::vector<const ModelRun*> scored;
  for (const ModelRun& run : runs)
    if (isScored(run))
      scored.push_back(&run);
  std::vector<ErrorCurve> curves;
  for (const auto& set : groupBy(scored, [](const ModelRun* run) { return run->model.set; })) {
    const auto classes = groupBy(set, [](const ModelRun* run) { return run->model.class_name; });
    ErrorCurve curve;
    curve.name = set.front()->model.set;
    for (int step = 0; step <= steps; ++step) {
      const double threshold = largest * step / steps;
      curve.thresholds.push_back(threshold);
      curve.shares.push_back(mean(classes, [&](const auto& models) {
        return mean(models, [&](const ModelRun* run) { return shareBelow(*run, threshold); });
      }));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace symmetry
} // namespace pcl
