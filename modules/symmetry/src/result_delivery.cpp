#include "symmetry/result_delivery.h"

#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/sides/axis_curve.h"
#include "symmetry/sides/axis_smoothing.h"
#include "symmetry/sides/mirror_plane.h"
#include "symmetry/sides/sides.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Numbers of points of the input in place of those of the prepared surface. */
class ToInput {
public:
  explicit ToInput(const PreparedSurface& prepared)
      : original_(prepared.original),
        representatives_(prepared.representatives),
        scale_(prepared.scale),
        centre_(prepared.centre)
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

  /** A place of the prepared surface in the unit of the input. */
  Vector3
  place(Vector3 p) const
  {
    for (std::size_t k = 0; k < p.size(); ++k) {
      p[k] = static_cast<float>(centre_[k] + p[k] / scale_);
    }
    return p;
  }

private:
  const std::vector<Index>& original_;
  const std::vector<Index>& representatives_;
  double scale_;
  const std::array<double, 3>& centre_;
};

/** Names the parts without a counterpart in numbers and units of the input; they are on no side. */
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
    // A place between points is told of the nearest of them, which may be left out.
    if (result.partners[v] != no_index && is_out[result.partners[v]] != 0) {
      result.partners[v] = no_index;
      result.confidences[v] = 0.0F;
    }
  }
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
deliverMap(const MapEstimate& estimate, const PreparedSurface& prepared, bool is_dense, SymmetryResult& result)
{
  const ToInput to_input(prepared);
  if (is_dense) {
    to_input.scatter(to_input.renumbered(estimate.partners), result.partners);
  }
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

/** What a map of points says of the sides is as coarse as the points and has specks; a plane says it exactly. */
std::vector<float>
cleanSideFunction(const MapEstimate& estimate, const PreparedSurface& prepared)
{
  const SurfaceGraph& graph = prepared.graph;
  return estimate.are_sides_exact
             ? withoutZeros(graph, estimate.side_function)
             : absorbSpecks(graph, smoothedNearAxis(prepared, absorbSpecks(graph, estimate.side_function)));
}

void
deliverSides(const MapEstimate& estimate, const PreparedSurface& prepared, bool label_axis, SymmetryResult& result)
{
  const ToInput to_input(prepared);
  const std::vector<float> side_function = cleanSideFunction(estimate, prepared);
  std::vector<Side> sides = labelSides(side_function);
  if (!estimate.partners.empty()) {
    result.plane =
        movedPlane(fitMirrorPlane(prepared.points, estimate.partners, sides), 1.0 / prepared.scale, prepared.centre);
  }
  if (label_axis) {
    markAxis(prepared.graph, side_function, estimate.partners, sides);
  }
  to_input.scatter(sides, result.sides);
  const bool is_partial = estimate.status == SymmetryStatus::PartlySymmetric;
  result.axis = traceAxis(prepared, side_function, is_partial ? estimate.is_unsupported : std::vector<char>{},
                          estimate.are_sides_exact);
  for (Polyline& line : result.axis) {
    line.points = to_input.renumbered(std::move(line.points));
    // Places between points are told of the nearest ones: several of the same.
    line.points.erase(std::unique(line.points.begin(), line.points.end()), line.points.end());
    while (line.closed && line.points.size() > 1 && line.points.front() == line.points.back()) {
      line.points.pop_back();
    }
    for (AxisPoint& point : line.curve) {
      point.position = to_input.place(point.position);
      point.arc_length /= prepared.scale;
      point.nearest = to_input(point.nearest);
    }
  }
  result.map.axis = static_cast<std::size_t>(std::count(result.sides.begin(), result.sides.end(), Side::Axis));
}

} // namespace

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

void
deliverResult(const MapEstimate& estimate,
              const PreparedSurface& prepared,
              const SymmetryParameters& parameters,
              SymmetryResult& result)
{
  deliverMap(estimate, prepared, !parameters.sparse_only, result);
  result.map.matched = static_cast<std::size_t>(
      std::count_if(result.partners.begin(), result.partners.end(), [](Index partner) { return partner != no_index; }));
  deliverSides(estimate, prepared, parameters.label_axis, result);
  if (estimate.status == SymmetryStatus::PartlySymmetric) {
    deliverUnsupported(estimate, prepared, result);
  }
}

} // namespace symmetry
} // namespace pcl
