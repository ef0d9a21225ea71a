#include "benchmark/confidence_metrics.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Judgements of equal confidence. */
struct Tie {
  double count = 0.0;
  double right = 0.0;
};

/** Groups of equal confidence, the most confident first. */
std::vector<Tie>
collectTies(std::vector<Judgement> judgements)
{
  std::sort(judgements.begin(), judgements.end(),
            [](const Judgement& a, const Judgement& b) { return a.confidence > b.confidence; });
  std::vector<Tie> ties;
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    if (i == 0 || judgements[i].confidence != judgements[i - 1].confidence)
      ties.emplace_back();
    ties.back().count += 1.0;
    ties.back().right += judgements[i].right ? 1.0 : 0.0;
  }
  return ties;
}

} // namespace

std::optional<double>
areaUnderRoc(std::vector<Judgement> judgements)
{
  double right = 0.0;
  double wrong = 0.0;
  double area = 0.0;
  for (const Tie& tie : collectTies(std::move(judgements))) {
    const double tie_wrong = tie.count - tie.right;
    area += tie_wrong * (right + 0.5 * tie.right);
    right += tie.right;
    wrong += tie_wrong;
  }
  if (right == 0.0 || wrong == 0.0)
    return std::nullopt;
  return area / (right * wrong);
}

std::vector<CoveragePoint>
coverageCurve(std::vector<Judgement> judgements, int steps)
{
  const auto total = static_cast<double>(judgements.size());
  const std::vector<Tie> ties = collectTies(std::move(judgements));
  std::vector<CoveragePoint> curve;
  if (ties.empty())
    return curve;
  std::size_t tie = 0;
  double count_before = 0.0;
  double right_before = 0.0;
  for (int step = 1; step <= steps; ++step) {
    const double coverage = static_cast<double>(step) / steps;
    const double kept = coverage * total;
    while (tie + 1 < ties.size() && count_before + ties[tie].count < kept) {
      count_before += ties[tie].count;
      right_before += ties[tie].right;
      ++tie;
    }
    const double fraction = (kept - count_before) / ties[tie].count;
    curve.push_back({coverage, (right_before + fraction * ties[tie].right) / kept});
  }
  return curve;
}

std::vector<Judgement>
judgeMaps(const std::vector<ModelRun>& runs, JudgedRuns which)
{
  std::vector<Judgement> judgements;
  for (const ModelRun& run : runs)
    if (run.score && (which == JudgedRuns::All || run.score->map_size > 0))
      judgements.push_back({run.confidence, run.score->isRight()});
  return judgements;
}

std::vector<Judgement>
judgeVertices(const std::vector<ModelRun>& runs)
{
  std::vector<Judgement> judgements;
  for (const ModelRun& run : runs) {
    if (!run.score)
      continue;
    for (const VertexError& error : run.score->errors) {
      const auto vertex = static_cast<std::size_t>(error.vertex);
      if (run.partners[vertex] != no_index)
        judgements.push_back({run.confidences[vertex], error.geodesic < right_vertex_error});
    }
  }
  return judgements;
}

} // namespace symmetry
} // namespace pcl
