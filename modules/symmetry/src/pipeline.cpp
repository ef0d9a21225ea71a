#include "symmetry/pipeline.h"

#include "symmetry/axis_curve.h"
#include "symmetry/map_quality.h"
#include "symmetry/robust_method.h"
#include "symmetry/sides.h"
#include "symmetry/staged_method.h"

#include <algorithm>
#include <optional>

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
estimateMap(const PreparedSurface& prepared, const SymmetryParameters& parameters, StepTimer& timer)
{
  if (parameters.method == Method::Staged) {
    return estimateStaged(prepared, parameters, timer);
  }
  static const RobustSettings default_settings;
  return estimateRobust(prepared, parameters, default_settings, timer);
}

struct Reading {
  PreparedSurface surface;
  MapEstimate estimate;
};

/** Which points of a cloud touch and which are connected cannot always be told: the ways to read it, the most trusting
 * first. */
std::vector<ContactTest>
contactTests(const Surface& surface, const SymmetryParameters& parameters, float depth = 0.0F)
{
  if (surface.hasFaces() || parameters.method == Method::Staged) {
    return {ContactTest{}};
  }
  return {{0.5F, 3.0F, depth}, {0.8F, 4.0F, depth}, {0.95F, 8.0F, depth}};
}

bool
isBetter(const MapEstimate& a, const MapEstimate& b)
{
  const bool a_found = a.status == SymmetryStatus::Symmetric;
  const bool b_found = b.status == SymmetryStatus::Symmetric;
  return a_found != b_found ? a_found : a.confidence > b.confidence;
}

bool
isSettled(const MapEstimate& estimate)
{
  constexpr float beyond_doubt = 0.9F;
  return estimate.confidence >= beyond_doubt || estimate.status == SymmetryStatus::TooFewPoints;
}

/** Tries ways to read a surface until one is beyond doubt. \param[in,out] best the most convincing one so far, if any;
 * \param[out] summary what was used, also if the timer cancels */
void
tryReadings(const UsablePoints& usable,
            const std::vector<ContactTest>& tests,
            const SymmetryParameters& parameters,
            StepTimer& timer,
            InputSummary& summary,
            std::optional<Reading>& best)
{
  for (const ContactTest& contact : tests) {
    timer.start("graph", 0.0);
    Reading reading;
    reading.surface = prepareSurface(usable, parameters, contact);
    summary = reading.surface.summary;
    reading.estimate = estimateMap(reading.surface, parameters, timer);
    if (!best || isBetter(reading.estimate, best->estimate)) {
      best = std::move(reading);
    }
    if (isSettled(best->estimate)) {
      return;
    }
  }
}

/** Reads the points of a surface in one way and their contacts in several. \param[in] depths see ContactTest
 * \param[in,out] best the most convincing reading so far, if any; the summary is that of the last one */
void
tryDepths(const Surface& surface,
          NoiseReading noise,
          const std::vector<float>& depths,
          const SymmetryParameters& parameters,
          const NeighbourSearch& search,
          StepTimer& timer,
          InputSummary& summary,
          std::optional<Reading>& best)
{
  timer.start("graph", 0.0);
  const UsablePoints usable = usablePoints(surface, parameters, search, noise);
  for (const float depth : depths) {
    tryReadings(usable, contactTests(surface, parameters, depth), parameters, timer, summary, best);
    if (isSettled(best->estimate)) {
      return;
    }
  }
}

/** Of the readings of a surface the one with the most convincing symmetry. \param[out] summary what was used, also if
 * the timer cancels */
Reading
bestReading(const Surface& surface,
            const SymmetryParameters& parameters,
            const NeighbourSearch& search,
            StepTimer& timer,
            InputSummary& summary)
{
  constexpr float doubtful = 0.3F;
  constexpr float contact = 1.0F; // spacings
  std::optional<Reading> best;
  const auto try_reading = [&](NoiseReading noise, const std::vector<float>& depths) {
    tryDepths(surface, noise, depths, parameters, search, timer, summary, best);
  };
  try_reading(NoiseReading::Smooth, {0.0F});
  if (surface.hasFaces() || parameters.method == Method::Staged || isSettled(best->estimate)) {
    return std::move(*best);
  }
  if (summary.smoothing_radius == 0.0F) {
    if (best->estimate.confidence < doubtful) {
      try_reading(NoiseReading::Parted, {contact});
    }
    return std::move(*best);
  }
  try_reading(NoiseReading::Close, {0.0F});
  if (!isSettled(best->estimate)) {
    // Noise makes each reading uncertain, so that several are worth their time.
    try_reading(NoiseReading::Parted, {contact, 0.0F, 0.7F * contact});
  }
  return std::move(*best);
}

void
estimateInto(SymmetryResult& result,
             const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             StepTimer& timer)
{
  const Reading reading = bestReading(surface, parameters, search, timer, result.input);
  const PreparedSurface& prepared = reading.surface;
  const MapEstimate& estimate = reading.estimate;
  result.input = prepared.summary;
  result.status = estimate.status;
  result.message = estimate.message;
  result.confidence = estimate.confidence;
  result.diameter = estimate.diameter / prepared.scale;
  if (estimate.status != SymmetryStatus::Symmetric) {
    return;
  }
  deliverMap(estimate, prepared, result);
  timer.start("quality", 0.85);
  result.map = measureMap(prepared, estimate.partners, estimate.diameter, parameters.threads);
  result.map.matched = static_cast<std::size_t>(
      std::count_if(result.partners.begin(), result.partners.end(), [](Index partner) { return partner != no_index; }));
  timer.start("axis", 0.9);
  deliverSides(estimate, prepared, result);
}

} // namespace

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
