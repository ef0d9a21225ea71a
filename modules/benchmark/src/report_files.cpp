#include "benchmark/report_files.h"

#include "benchmark/confidence_metrics.h"
#include "benchmark/summary.h"
#include "io/write/output_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Keeps the order in which the members are added. */
using Json = nlohmann::ordered_json;

std::string
thresholdName(double threshold)
{
  return "below_" + std::to_string(threshold).substr(0, 4);
}

Json
describeScore(const MapAccuracy& score)
{
  Json object;
  object["truth"] = score.errors.size();
  object["matched"] = score.matched;
  object["map_size"] = score.map_size;
  object["correspondence_rate"] = score.correspondenceRate();
  object["mean_geodesic_error"] = score.meanGeodesicError();
  for (const double threshold : error_thresholds)
    object[thresholdName(threshold)] = score.shareBelow(threshold);
  object["radius"] = score.radius;
  object["diameter"] = score.diameter;
  return object;
}

/** The scalar figures of a run; a run without score has the same members, null. */
Json
describeRun(const ModelRun& run)
{
  Json object;
  object["set"] = run.model.set;
  object["class"] = run.model.class_name;
  object["model"] = run.model.name;
  object["points"] = run.points;
  object["faces"] = run.faces;
  object["status"] = run.failure.empty() ? toString(run.status) : "failed";
  object["confidence"] = run.confidence;
  const Json score = describeScore(run.score.value_or(MapAccuracy{}));
  for (const auto& [name, value] : score.items())
    object[name] = run.score ? value : Json();
  // A failed run counts as wrong in every mean, so it does here.
  if (!run.failure.empty() && !run.model.truth.empty()) {
    object["correspondence_rate"] = 0.0;
    object["mean_geodesic_error"] = 1.0;
  }
  object["involution"] = run.map.involution;
  object["inverted_faces"] = run.map.inverted_faces;
  object["torn_faces"] = run.map.torn_faces;
  object["isometry_error"] = run.map.isometry_error;
  object["message"] = run.failure.empty() ? run.message : run.failure;
  return object;
}

Json
describeSeconds(const ModelRun& run)
{
  Json object = Json::object();
  for (const auto& [step, seconds] : run.seconds)
    object[step] = seconds;
  object["total"] = run.totalSeconds();
  return object;
}

Json
describeGroup(const GroupSummary& group)
{
  Json object;
  object["set"] = group.set;
  if (!group.class_name.empty())
    object["class"] = group.class_name;
  object["models"] = group.models;
  object["failed"] = group.failed;
  object["symmetric"] = group.symmetric;
  object["correspondence_rate"] = group.correspondence_rate;
  object["mesh_rate"] = group.mesh_rate;
  object["mean_geodesic_error"] = group.mean_geodesic_error;
  for (std::size_t i = 0; i < error_thresholds.size(); ++i)
    object[thresholdName(error_thresholds[i])] = group.below[i];
  object["mean_confidence"] = group.mean_confidence;
  object["mean_seconds"] = group.mean_seconds;
  return object;
}

Json
describeMapConfidence(const std::vector<Judgement>& maps)
{
  const std::optional<double> area = areaUnderRoc(maps);
  Json object;
  object["maps"] = maps.size();
  object["right"] = std::count_if(maps.begin(), maps.end(), [](const Judgement& j) { return j.right; });
  object["area_under_roc"] = area ? Json(*area) : Json();
  return object;
}

Json
describeConfidence(const std::vector<ModelRun>& runs)
{
  Json object;
  object["all_runs"] = describeMapConfidence(judgeMaps(runs, JudgedRuns::All));
  object["delivered_maps"] = describeMapConfidence(judgeMaps(runs, JudgedRuns::Delivered));
  object["vertices"] = Json::array();
  for (const CoveragePoint& point : coverageCurve(judgeVertices(runs)))
    object["vertices"].push_back({{"coverage", point.coverage}, {"accuracy", point.accuracy}});
  return object;
}

Json
describeOptions(const RunOptions& options)
{
  const SymmetryParameters& parameters = options.parameters;
  Json object;
  object["method"] = parameters.method == Method::Robust ? "robust" : "staged";
  object["metric"] = parameters.metric == Metric::Geodesic ? "geodesic" : "euclidean";
  object["as_cloud"] = options.as_cloud;
  object["noise"] = options.disturbance.noise;
  object["drop"] = options.disturbance.drop;
  object["outliers"] = options.disturbance.outliers;
  object["holes"] = options.disturbance.holes;
  object["hole_share"] = options.disturbance.hole_share;
  object["thin"] = options.disturbance.thin;
  object["quantise"] = options.disturbance.quantise;
  object["bend"] = options.disturbance.bend;
  object["repeat"] = options.disturbance.repeat;
  object["seed"] = options.disturbance.seed;
  if (options.cut_limb)
    object["cut_limb"] = *options.cut_limb == Limb::Farthest ? "farthest" : "other";
  object["k_search"] = parameters.k_search;
  object["robust"] = {{"samples", parameters.robust.samples}};
  object["staged"] = {{"landmarks", parameters.staged.landmarks}, {"samples", parameters.staged.samples}};
  object["threads"] = parameters.threads;
  return object;
}

/** A value of the CSV table; text that would break the table is quoted. */
std::string
csvValue(const Json& value)
{
  if (value.is_null())
    return "";
  if (!value.is_string())
    return value.dump();
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  for (std::size_t quote = text.find('"'); quote != std::string::npos; quote = text.find('"', quote + 2))
    text.insert(quote, 1, '"');
  return '"' + text + '"';
}

/** Names of all steps, in the order in which they first occur. */
std::vector<std::string>
collectSteps(const std::vector<ModelRun>& runs)
{
  std::vector<std::string> steps;
  for (const ModelRun& run : runs)
    for (const auto& step : run.seconds)
      if (std::find(steps.begin(), steps.end(), step.first) == steps.end())
        steps.push_back(step.first);
  steps.emplace_back("total");
  return steps;
}

} // namespace

void
writeCsvReport(const std::string& path, const std::vector<ModelRun>& runs)
{
  const std::vector<std::string> steps = collectSteps(runs);
  const Json columns = describeRun(ModelRun{});
  std::string table;
  for (const auto& [name, value] : columns.items())
    table += (table.empty() ? "" : ",") + name;
  for (const std::string& step : steps)
    table += ",seconds_" + step;
  table += '\n';
  for (const ModelRun& run : runs) {
    const Json figures = describeRun(run);
    std::string line;
    for (const auto& [name, value] : figures.items())
      line += (line.empty() ? "" : ",") + csvValue(value);
    const Json seconds = describeSeconds(run);
    for (const std::string& step : steps)
      line += "," + csvValue(seconds.value(step, Json()));
    table += line + '\n';
  }
  writeWholeFile(path, table);
}

void
writeJsonReport(const std::string& path, const std::vector<ModelRun>& runs, const RunOptions& options)
{
  Json report;
  report["parameters"] = describeOptions(options);
  report["models"] = Json::array();
  for (const ModelRun& run : runs) {
    report["models"].push_back(describeRun(run));
    report["models"].back()["seconds"] = describeSeconds(run);
  }
  const std::vector<GroupSummary> classes = summariseClasses(runs);
  for (const GroupSummary& group : classes)
    report["classes"].push_back(describeGroup(group));
  for (const GroupSummary& group : summariseSets(classes))
    report["sets"].push_back(describeGroup(group));
  for (const ErrorCurve& curve : errorCurves(runs))
    report["curves"].push_back({{"set", curve.name}, {"thresholds", curve.thresholds}, {"shares", curve.shares}});
  report["confidence"] = describeConfidence(runs);
  writeWholeFile(path, report.dump(2) + '\n');
}

void
writeJsonScore(const std::string& path, const MapAccuracy& score)
{
  writeWholeFile(path, describeScore(score).dump(2) + '\n');
}

} // namespace symmetry
} // namespace pcl
