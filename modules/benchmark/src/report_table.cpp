#include "benchmark/report_table.h"

#include "base/statistics.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <ostream>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

/** A number with a fixed number of decimals, aligned to the right. */
std::string
number(double value, int width, int decimals)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%*.*f", width, decimals, value);
  return text.data();
}

std::string
percent(double share, int width)
{
  return number(100.0 * share, width, 1);
}

std::string
left(const std::string& text, std::size_t width)
{
  return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string
right(const std::string& text, std::size_t width)
{
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

constexpr std::size_t name_width = 28;

void
printSummary(std::ostream& out, const GroupSummary& summary, const std::string& name)
{
  out << left(name, name_width) << right(std::to_string(summary.models), 7) << percent(summary.correspondence_rate, 8)
      << percent(summary.mesh_rate, 8) << number(summary.mean_geodesic_error, 9, 4);
  for (const double share : summary.below)
    out << percent(share, 7);
  out << right(std::to_string(summary.symmetric), 10) << number(summary.mean_confidence, 8, 3)
      << number(summary.mean_seconds, 9, 3);
  if (summary.failed > 0)
    out << "  " << summary.failed << " failed";
  out << '\n';
}

void
printSteps(std::ostream& out, const ModelRun& run)
{
  const std::string indent(4, ' ');
  out << indent << "seconds:";
  for (const auto& [step, seconds] : run.seconds)
    out << ' ' << step << number(seconds, 0, 3).insert(0, " ") << ',';
  out << " total " << number(run.totalSeconds(), 0, 3) << '\n';
  out << indent << "map: " << run.map.matched << " matched, " << run.map.axis << " on the axis, involution "
      << number(run.map.involution, 0, 4) << ", inverted faces " << number(run.map.inverted_faces, 0, 4)
      << ", torn faces " << number(run.map.torn_faces, 0, 4) << ", isometry error "
      << number(run.map.isometry_error, 0, 4) << '\n';
  if (!run.message.empty())
    out << indent << "message: " << run.message << '\n';
}

void
printMapConfidence(std::ostream& out, const std::string& name, const std::vector<Judgement>& maps)
{
  const auto right_maps = std::count_if(maps.begin(), maps.end(), [](const Judgement& j) { return j.right; });
  const std::optional<double> area = areaUnderRoc(maps);
  out << "map confidence, " << name << ": " << right_maps << " of " << maps.size()
      << " right, area under the ROC curve " << (area ? number(*area, 0, 4) : "undefined (none right or none wrong)")
      << '\n';
}

/** Whether the confidence of vertices tells right from wrong within each set, and how often it is as it says. */
void
printVertexConfidence(std::ostream& out, const std::vector<ModelRun>& runs)
{
  std::map<std::string, std::vector<ModelRun>> sets;
  for (const ModelRun& run : runs)
    sets[run.model.set].push_back(run);
  out << "vertex confidence: area under the ROC curve";
  for (const auto& [set, of_set] : sets)
    if (const std::optional<double> area = areaUnderRoc(judgeVertices(of_set)))
      out << ' ' << set << number(*area, 6, 3);
  out << "\nvertex confidence: right";
  constexpr int bins = 5;
  std::array<double, bins> count{};
  std::array<double, bins> right{};
  for (const Judgement& judgement : judgeVertices(runs)) {
    const auto bin = static_cast<std::size_t>(std::clamp(static_cast<int>(bins * judgement.confidence), 0, bins - 1));
    count[bin] += 1.0;
    right[bin] += judgement.right ? 1.0 : 0.0;
  }
  for (std::size_t bin = 0; bin < bins; ++bin)
    if (count[bin] > 0.0)
      out << ' ' << percent(right[bin] / count[bin], 0) << " % of " << number(count[bin], 0, 0) << " below "
          << number(static_cast<double>(bin + 1) / bins, 0, 1) << (bin + 1 < bins ? "," : "");
  out << '\n';
}

} // namespace

void
printModelHeader(std::ostream& out)
{
  out << left("model", name_width) << right("points", 9) << right("rate %", 8) << right("error", 8)
      << right("matched", 11) << right("conf.", 8) << right("seconds", 9) << "  status\n";
}

void
printModel(std::ostream& out, const ModelRun& run, bool verbose)
{
  out << left(run.model.set + "/" + run.model.name, name_width) << right(std::to_string(run.points), 9);
  if (!run.failure.empty()) {
    out << "  failed: " << run.failure << '\n';
    return;
  }
  if (run.score)
    out << percent(run.score->correspondenceRate(), 8) << number(run.score->meanGeodesicError(), 8, 4)
        << right(std::to_string(run.score->matched) + "/" + std::to_string(run.score->errors.size()), 11);
  else
    out << right("-", 8) << right("-", 8) << right("-", 11);
  out << number(run.confidence, 8, 3) << number(run.totalSeconds(), 9, 3) << "  " << toString(run.status);
  if (run.odd_part)
    out << ", without partner" << percent(run.odd_part->found_share, 5) << " % of the area, odd"
        << percent(run.odd_part->true_share, 5) << " %, rest right" << percent(run.odd_part->rest_rate, 6) << " %";
  out << '\n';
  if (verbose)
    printSteps(out, run);
}

void
printSummaries(std::ostream& out, const std::vector<GroupSummary>& classes, const std::vector<GroupSummary>& sets)
{
  out << left("class", name_width) << right("models", 7) << right("rate %", 8) << right("mesh %", 8)
      << right("error", 9);
  for (const double threshold : error_thresholds)
    out << right("<" + number(threshold, 0, 2), 7);
  out << right("symmetric", 10) << right("conf.", 8) << right("seconds", 9) << '\n';
  for (const GroupSummary& set : sets) {
    for (const GroupSummary& one : classes)
      if (one.set == set.set)
        printSummary(out, one, one.set + "/" + one.class_name);
    printSummary(out, set, set.set + " (mean of classes)");
  }
}

void
printConfidence(std::ostream& out, const std::vector<ModelRun>& runs)
{
  printMapConfidence(out, "all runs", judgeMaps(runs, JudgedRuns::All));
  printMapConfidence(out, "delivered maps", judgeMaps(runs, JudgedRuns::Delivered));

  const std::vector<CoveragePoint> curve = coverageCurve(judgeVertices(runs), 5);
  if (curve.empty())
    return;
  out << "vertex confidence: right";
  for (const CoveragePoint& point : curve)
    out << (point.coverage == curve.front().coverage ? " " : ", ") << percent(point.accuracy, 0) << " % of the best "
        << number(100.0 * point.coverage, 0, 0) << " %";
  out << '\n';
  printVertexConfidence(out, runs);
}

void
printRefusals(std::ostream& out, const std::vector<ModelRun>& runs)
{
  constexpr float doubtful = 0.5F;
  struct Counts {
    std::size_t models = 0;
    std::size_t refused = 0;
    std::size_t partial = 0;
    std::size_t doubted = 0;
    std::vector<double> found{}; ///< unsupported area over that of the odd part
    double rest_rate = 0.0;
  };
  std::map<std::string, Counts> sets;
  for (const ModelRun& run : runs) {
    if (!run.failure.empty())
      continue;
    Counts& counts = sets[run.model.set];
    ++counts.models;
    counts.refused += run.status == SymmetryStatus::NoSymmetry ? 1 : 0;
    counts.partial += run.status == SymmetryStatus::PartlySymmetric ? 1 : 0;
    counts.doubted += run.status == SymmetryStatus::Symmetric && run.confidence < doubtful ? 1 : 0;
    if (run.status == SymmetryStatus::PartlySymmetric && run.odd_part && run.odd_part->true_share > 0.0) {
      counts.found.push_back(run.odd_part->found_share / run.odd_part->true_share);
      counts.rest_rate += run.odd_part->rest_rate;
    }
  }
  out << left("set", name_width) << right("models", 7) << right("refused", 9) << right("partial", 9)
      << right("conf. < 0.5", 13) << right("more", 6) << right("odd area", 10) << right("rest %", 8) << '\n';
  for (const auto& [set, counts] : sets) {
    out << left(set, name_width) << right(std::to_string(counts.models), 7) << right(std::to_string(counts.refused), 9)
        << right(std::to_string(counts.partial), 9) << right(std::to_string(counts.doubted), 13)
        << right(std::to_string(counts.models - counts.refused - counts.partial - counts.doubted), 6);
    if (!counts.found.empty())
      out << number(median(counts.found), 10, 2)
          << percent(counts.rest_rate / static_cast<double>(counts.found.size()), 8);
    out << '\n';
  }
}

void
printVariants(std::ostream& out, const std::vector<VariantSummary>& summaries)
{
  out << left("variant", name_width) << right("models", 7) << right("rate %", 8) << right("right", 7)
      << right("refused", 9) << right("wrong > 0.5", 13) << right("as the model itself", 21) << '\n';
  for (const VariantSummary& summary : summaries) {
    const std::string name = summary.variant == Variant::AsItIs ? "as it is" : toString(summary.variant);
    out << left(summary.set + ", " + name, name_width) << right(std::to_string(summary.models), 7)
        << percent(summary.correspondence_rate, 8) << right(std::to_string(summary.right), 7)
        << right(std::to_string(summary.refused), 9) << right(std::to_string(summary.sure_but_wrong), 13)
        << right(std::to_string(summary.alike), 21) << '\n';
  }
}

void
printScore(std::ostream& out, const MapAccuracy& score)
{
  out << "correspondence rate " << number(score.correspondenceRate(), 0, 4) << "  mean geodesic error "
      << number(score.meanGeodesicError(), 0, 4) << "  matched " << score.matched << '/' << score.errors.size() << '\n';
}

} // namespace symmetry
} // namespace pcl
