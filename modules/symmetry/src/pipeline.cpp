#include "symmetry/pipeline.h"

#include "base/heartbeat.h"
#include "symmetry/cloud_as_it_stands.h"
#include "symmetry/confidence/calibration.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/part_twins.h"
#include "symmetry/confidence/point_confidence.h"
#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/interpretations.h"
#include "symmetry/odd_limb.h"
#include "symmetry/result_delivery.h"
#include "symmetry/robust_method.h"
#include "symmetry/sides/map_quality.h"
#include "symmetry/staged/staged_method.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

MapEstimate
estimateMap(const PreparedSurface& prepared,
            const SymmetryParameters& parameters,
            float samples,
            const std::vector<std::vector<Index>>& known,
            StepTimer& timer)
{
  if (parameters.method == Method::Staged) {
    return estimateStaged(prepared, parameters, timer);
  }
  return estimateRobust(prepared, parameters, robustSettings(parameters, samples), timer, known);
}

/** Share of the points below which a part of the object is missing. */
constexpr float nearly_all = 0.9F;

/** Share below which there is no symmetry of the object. */
constexpr float half = 0.5F;

/** Share of the usable points of the input that took part; what was not asked for does not count. */
float
shareUsed(const InputSummary& input, ComponentUse use)
{
  const std::size_t unasked = use == ComponentUse::Largest ? input.other_components : 0;
  const std::size_t left_out = input.non_finite + input.outside_indices + input.outliers + input.unused + unasked;
  return input.points <= left_out ? 1.0F : static_cast<float>(input.used) / static_cast<float>(input.points - left_out);
}

void
addRemark(SymmetryResult& result, const std::string& remark)
{
  result.message += (result.message.empty() ? "" : "; ") + remark;
}

/** A map of a part of the input is at most that part right, says so, and is the symmetry of a part; of less than half of
 * the input it is none. */
void
judgeShareUsed(SymmetryResult& result, ComponentUse use)
{
  const float share = shareUsed(result.input, use);
  if (share >= nearly_all) {
    return;
  }
  result.confidence = std::min(result.confidence, share);
  addRemark(result, std::to_string(std::lround(100.0F * (1.0F - share))) +
                        " % of the points lie apart from the part that was mapped");
  if (share >= half) {
    result.status = SymmetryStatus::PartlySymmetric;
    return;
  }
  result.status = SymmetryStatus::NoSymmetry;
  result.confidence *= confidence_of_refused;
  addRemark(result, "that is less than half: ask for the largest component alone, or cut the others off");
}

/** What explains less than half of the surface is no symmetry of it. */
void
judgeShareMapped(SymmetryResult& result, float share)
{
  if (share < half) {
    result.status = SymmetryStatus::NoSymmetry;
    result.confidence *= confidence_of_refused;
    addRemark(result, "less than half of the surface has a counterpart");
  }
}

/** What became of the points of the input, for those who are told that there are too few. */
std::string
describePoints(const InputSummary& input)
{
  std::string text = "of " + std::to_string(input.points) + " points ";
  for (const auto& [count, reason] : {std::pair(input.non_finite, " are no finite places, "),
                                      {input.outliers, " are outliers, "},
                                      {input.other_components, " are in other parts, "}}) {
    if (count > 0) {
      text += std::to_string(count) + reason;
    }
  }
  return text + std::to_string(input.working_points) + " at distinct places are left";
}

/** The whole method. */
void
estimateInto(SymmetryResult& result,
             const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             StepTimer& timer)
{
  Interpretation interpretation = interpretSurface(surface, parameters, search, timer, result.input);
  if (interpretation.estimate.status == SymmetryStatus::PartlySymmetric) {
    leaveOutUnsupported(interpretation.estimate);
  }
  const PreparedSurface& prepared = interpretation.surface;
  MapEstimate& estimate = interpretation.estimate;
  result.input = prepared.summary;
  result.status = estimate.status;
  result.message = estimate.message;
  result.confidence = estimate.confidence;
  result.diameter = estimate.diameter / prepared.scale;
  if (estimate.status == SymmetryStatus::TooFewPoints) {
    result.message += "; " + describePoints(result.input);
  }
  if (!hasMap(estimate.status)) {
    return;
  }
  // Judge once more: no map is better than what is measured on it.
  timer.start("quality", 0.85);
  MapSummary measured;
  if (!estimate.partners.empty()) {
    measured = measureMap(prepared, estimate.partners, estimate.diameter);
    const float twins = shareOfTwinParts(prepared, estimate.partners);
    result.confidence = std::min({result.confidence, confidenceBound(measured), twins});
  }
  const bool has_faces = !prepared.is_cloud || prepared.summary.read_as_cloud; // which tell what is between the points
  const RefusalCalibration refusal;
  if (result.confidence < (has_faces ? refusal.several_interpretations : refusal.uncertain)) {
    result.status = SymmetryStatus::NoSymmetry;
    result.message = "the map that fits best tears the surface apart";
    result.confidence *= confidence_of_refused;
    return;
  }
  judgeShareUsed(result, parameters.components);
  if (result.status == SymmetryStatus::PartlySymmetric && !estimate.partners.empty()) {
    judgeShareMapped(result, shareWithPartner(prepared, estimate.partners));
  }
  if (!hasMap(result.status)) {
    return;
  }
  for (float& confidence : estimate.confidences) {
    confidence = withMapConfidence(confidence, estimate.confidence, result.confidence);
  }
  result.equal_reflections = estimate.equal_reflections;
  if (result.equal_reflections > 1) {
    addRemark(result, std::to_string(result.equal_reflections) + " reflections fit equally well");
  }
  // Deliver: in numbers of the input's points; sides and the curve between them.
  result.map = parameters.sparse_only ? MapSummary{} : measured;
  timer.start("axis", 0.9);
  deliverResult(estimate, prepared, parameters, result);
}

} // namespace

Interpretation
interpretSurface(const Surface& surface,
                 const SymmetryParameters& parameters,
                 const NeighbourSearch& search,
                 StepTimer& timer,
                 InputSummary& summary,
                 const std::function<void(const Interpretation&)>& observer)
{
  timer.start("graph", 0.0);
  std::optional<CloudAsItStands> as_it_stands;
  if (!surface.hasFaces() && parameters.method == Method::Robust) {
    as_it_stands.emplace(surface, parameters, search);
  }
  if (as_it_stands && as_it_stands->isInParts()) {
    if (std::optional<Interpretation> mirrored = as_it_stands->mirrored(0.0F, timer)) {
      return std::move(*mirrored);
    }
    as_it_stands.reset();
  }
  // Interpret: in one way after another until the result is settled; the ways vote.
  InterpretationPlan plan(surface, parameters, search);
  RivalInterpretations rivals(plan.pooling());
  while (std::optional<InterpretationPlan::Attempt> attempt = plan.next(rivals)) {
    // Prepare: points cleaned, graph built, at unit scale; done by the plan.
    summary = attempt->surface.summary;
    // Sample, search, refine, judge: by either method.
    MapEstimate estimate =
        estimateMap(attempt->surface, parameters, attempt->samples, rivals.mapsOn(attempt->surface), timer);
    Interpretation interpretation{std::move(attempt->surface), std::move(estimate)};
    if (observer) {
      observer(interpretation);
    }
    rivals.add(std::move(interpretation));
    timer.start("graph", 0.0);
  }
  Interpretation best = rivals.takeBest();
  if (parameters.method == Method::Robust) {
    if (std::optional<Interpretation> rest = mapWithoutOddLimb(best, parameters, timer)) {
      best = std::move(*rest);
    }
  }
  const float share = shareUsed(best.surface.summary, parameters.components);
  if (as_it_stands && (best.estimate.status != SymmetryStatus::Symmetric || best.estimate.confidence < in_doubt ||
                       share < nearly_all)) {
    const float certain = std::min(best.estimate.confidence, share);
    if (std::optional<Interpretation> mirrored = as_it_stands->mirrored(certain, timer)) {
      return std::move(*mirrored);
    }
  }
  return best;
}

SymmetryResult
runPipeline(const Surface& surface,
            const SymmetryParameters& parameters,
            const NeighbourSearch& search,
            StepTimer& timer)
{
  SymmetryResult result = emptyResult(surface);
  const HeartbeatScope alive([&timer] { timer.beat(); });
  try {
    estimateInto(result, surface, parameters, search, timer);
  }
  catch (const Cancelled&) {
    const InputSummary input = result.input;
    result = emptyResult(surface);
    result.input = input;
    result.status = SymmetryStatus::Cancelled;
    result.message = "cancelled by the progress callback";
  }
  timer.stop();
  result.seconds = timer.seconds();
  return result;
}

} // namespace symmetry
} // namespace pcl
