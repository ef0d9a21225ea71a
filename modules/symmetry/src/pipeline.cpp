#include "symmetry/pipeline.h"

#include "symmetry/confidence/map_confidence.h"
#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/interpretations.h"
#include "symmetry/robust_method.h"
#include "symmetry/sides/axis_curve.h"
#include "symmetry/sides/map_quality.h"
#include "symmetry/sides/sides.h"
#include "symmetry/staged/staged_method.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** A result that says nothing about any point. */
SymmetryResult
emptyResult(const Surface& surface)
{
  SymmetryResult result;
  result.partners.assign(surface.size(), no_index);
  result.confidences.assign(surface.size(), 0.0F);
  result.support.assign(surface.size(), 0.0F);
  result.sides.assign(surface.size(), Side::None);
  result.regions.assign(surface.size(), Region::None);
  result.input.points = surface.size();
  result.input.faces = surface.triangles.size();
  return result;
}

/** Numbers of points of the input in place of those of the prepared surface. */
class ToInput {
public:
  explicit ToInput(const PreparedSurface& prepared)
      : original_(prepared.original), representatives_(prepared.representatives)
  {
  }

  Index
  operator()(Index v) const
  {
    return v == no_index ? no_index : original_[v];
  }

  /** Every point of the input gets the value of the point that stands for it. */
  template <typename Value>
  void
  scatter(const std::vector<Value>& from, std::vector<Value>& to) const
  {
    if (from.empty()) {
      return;
    }
    for (std::size_t v = 0; v < to.size(); ++v) {
      if (representatives_[v] != no_index) {
        to[v] = from[representatives_[v]];
      }
    }
  }

  /** No partner for any point of the input. */
  std::vector<Index>
  unassigned() const
  {
    std::vector<Index> none(representatives_.size(), no_index);
    return none;
  }

  std::vector<Index>
  renumbered(std::vector<Index> points) const
  {
    std::transform(points.begin(), points.end(), points.begin(), *this);
    return points;
  }

private:
  const std::vector<Index>& original_;
  const std::vector<Index>& representatives_;
};

/** Appends the stretches of a line that are not left out. */
void
appendSupported(const Polyline& line, const std::vector<char>& is_out, std::vector<Polyline>& to)
{
  if (std::none_of(line.points.begin(), line.points.end(), [&](Index v) { return is_out[v] != 0; })) {
    to.push_back(line);
    return;
  }
  Polyline stretch;
  const auto finish = [&] {
    if (stretch.points.size() > 1) {
      to.push_back(stretch);
    }
    stretch.points.clear();
  };
  for (const Index v : line.points) {
    if (is_out[v] != 0) {
      finish();
    }
    else {
      stretch.points.push_back(v);
    }
  }
  finish();
}

/** Takes the parts without a counterpart, and what is sent there, out of a partial map. */
void
leaveOutUnsupported(MapEstimate& estimate)
{
  std::vector<char>& is_out = estimate.is_unsupported;
  for (std::size_t v = 0; v < estimate.partners.size(); ++v) {
    const Index partner = estimate.partners[v];
    if (is_out[v] != 0 || partner == no_index || estimate.is_unsupported[partner] != 0) {
      estimate.partners[v] = no_index;
      estimate.confidences[v] = 0.0F;
      estimate.regions[v] = Region::None;
      estimate.support[v] = is_out[v] != 0 ? 0.0F : estimate.support[v];
    }
  }
  const auto is_left_out = [&](Index v) {
    return is_out[v] != 0;
  };
  estimate.matches.erase(std::remove_if(estimate.matches.begin(), estimate.matches.end(),
                                        [&](const SymmetricMatch& match) {
                                          return is_left_out(match.source) || is_left_out(match.target);
                                        }),
                         estimate.matches.end());
  estimate.extremities.erase(std::remove_if(estimate.extremities.begin(), estimate.extremities.end(), is_left_out),
                             estimate.extremities.end());
}

/** Names the parts without a counterpart in numbers and units of the input; they are on no side, and no curve runs
 * through them. */
void
deliverUnsupported(const MapEstimate& estimate, const PreparedSurface& prepared, SymmetryResult& result)
{
  const ToInput to_input(prepared);
  result.unsupported = unsupportedParts(prepared, estimate.is_unsupported);
  for (UnsupportedPart& part : result.unsupported) {
    part.extent /= prepared.scale;
    part.extreme = to_input(part.extreme);
  }
  std::vector<char> is_out(result.sides.size(), 0);
  to_input.scatter(estimate.is_unsupported, is_out);
  for (std::size_t v = 0; v < is_out.size(); ++v) {
    result.sides[v] = is_out[v] != 0 ? Side::None : result.sides[v];
  }
  std::vector<Polyline> kept;
  for (const Polyline& line : result.axis) {
    appendSupported(line, is_out, kept);
  }
  result.axis = std::move(kept);
  result.map.axis = static_cast<std::size_t>(std::count(result.sides.begin(), result.sides.end(), Side::Axis));
}

void
deliverAlternatives(const std::vector<AlternativeMap>& from, const ToInput& to_input, std::vector<AlternativeMap>& to)
{
  to = from;
  for (AlternativeMap& alternative : to) {
    const std::vector<Index> partners = to_input.renumbered(std::move(alternative.partners));
    alternative.partners = to_input.unassigned();
    to_input.scatter(partners, alternative.partners);
  }
}

void
deliverMap(const MapEstimate& estimate, const PreparedSurface& prepared, SymmetryResult& result)
{
  const ToInput to_input(prepared);
  to_input.scatter(to_input.renumbered(estimate.partners), result.partners);
  to_input.scatter(estimate.confidences, result.confidences);
  to_input.scatter(estimate.regions, result.regions);
  to_input.scatter(estimate.support, result.support);
  result.extremities = to_input.renumbered(estimate.extremities);
  for (const SymmetricMatch& match : estimate.matches) {
    result.matches.push_back({to_input(match.source), to_input(match.target), to_input(match.midpoint), match.cost});
  }
  deliverAlternatives(estimate.alternatives, to_input, result.alternatives);
  deliverAlternatives(estimate.rotations, to_input, result.rotations);
}

void
deliverSides(const MapEstimate& estimate, const PreparedSurface& prepared, SymmetryResult& result)
{
  const ToInput to_input(prepared);
  const std::vector<float> side_function = absorbSpecks(prepared.graph, estimate.side_function);
  const std::vector<Side> sides = labelSides(prepared.graph, side_function);
  to_input.scatter(sides, result.sides);
  // The triangles of a cloud are no manifold to trace a line through; its graph will do.
  const std::vector<Triangle> faces = prepared.is_cloud ? std::vector<Triangle>{} : prepared.triangles;
  for (Polyline& line : traceAxis(prepared.graph, faces, side_function, sides)) {
    line.points = to_input.renumbered(std::move(line.points));
    result.axis.push_back(std::move(line));
  }
  result.map.axis = static_cast<std::size_t>(std::count(result.sides.begin(), result.sides.end(), Side::Axis));
}

MapEstimate
estimateMap(const PreparedSurface& prepared, const SymmetryParameters& parameters, float samples, StepTimer& timer)
{
  if (parameters.method == Method::Staged) {
    return estimateStaged(prepared, parameters, timer);
  }
  RobustSettings settings;
  const float usual =
      parameters.samples > 0 ? static_cast<float>(parameters.samples) : static_cast<float>(settings.sampling.samples);
  settings.sampling.samples = std::max(minimum_samples, static_cast<std::size_t>(std::lround(samples * usual)));
  return estimateRobust(prepared, parameters, settings, timer);
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
  if (parameters.sparse_only) {
    interpretation.estimate.partners.clear(); // only now: interpretations are compared by their dense maps
  }
  const PreparedSurface& prepared = interpretation.surface;
  const MapEstimate& estimate = interpretation.estimate;
  result.input = prepared.summary;
  result.status = estimate.status;
  result.message = estimate.message;
  result.confidence = estimate.confidence;
  result.diameter = estimate.diameter / prepared.scale;
  if (!hasMap(estimate.status)) {
    return;
  }
  // Judge once more: no map is better than what is measured on it.
  timer.start("quality", 0.85);
  const MapSummary measured = estimate.partners.empty()
                                  ? MapSummary{}
                                  : measureMap(prepared, estimate.partners, estimate.diameter, parameters.threads);
  if (!estimate.partners.empty()) {
    result.confidence = std::min(result.confidence, confidenceBound(measured));
  }
  if (result.confidence < leastMapConfidence(1.0F)) {
    result.status = SymmetryStatus::NoSymmetry;
    result.message = "the map that fits best tears the surface apart";
    result.confidence *= confidence_of_refused;
    return;
  }
  // Deliver: in numbers of the input's points; sides and the curve between them.
  deliverMap(estimate, prepared, result);
  result.map = measured;
  result.map.matched = static_cast<std::size_t>(
      std::count_if(result.partners.begin(), result.partners.end(), [](Index partner) { return partner != no_index; }));
  timer.start("axis", 0.9);
  deliverSides(estimate, prepared, result);
  if (estimate.status == SymmetryStatus::PartlySymmetric) {
    deliverUnsupported(estimate, prepared, result);
  }
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
  // Interpret: in one way after another until the result is settled; the ways vote.
  InterpretationPlan plan(surface, parameters, search);
  RivalInterpretations rivals(plan.pooling());
  timer.start("graph", 0.0);
  while (std::optional<InterpretationPlan::Attempt> attempt = plan.next(rivals)) {
    // Prepare: points cleaned, graph built, at unit scale; done by the plan.
    summary = attempt->surface.summary;
    // Sample, search, refine, judge: by either method.
    MapEstimate estimate = estimateMap(attempt->surface, parameters, attempt->samples, timer);
    Interpretation interpretation{std::move(attempt->surface), std::move(estimate)};
    if (observer) {
      observer(interpretation);
    }
    rivals.add(std::move(interpretation));
    timer.start("graph", 0.0);
  }
  return rivals.takeBest();
}

SymmetryResult
runPipeline(const Surface& surface,
            const SymmetryParameters& parameters,
            const NeighbourSearch& search,
            StepTimer& timer)
{
  SymmetryResult result = emptyResult(surface);
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
