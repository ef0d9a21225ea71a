#include "symmetry/sides/axis_curve.h"

#include "symmetry/sides/curve_thinning.h"
#include "symmetry/sides/mesh_contour.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr AxisSettings settings{};

/** Takes out repetitions, spikes, small loops and detours around a single vertex. */
void
straighten(const SurfaceGraph& graph, Polyline& line)
{
  std::vector<Index> points;
  for (const Index v : line.points) {
    const auto recent = points.end() - std::min<std::ptrdiff_t>(settings.longest_loop, points.end() - points.begin());
    const auto again = std::find(recent, points.end(), v);
    if (again != points.end()) {
      points.erase(again + 1, points.end());
      continue;
    }
    while (points.size() >= 2 && areNeighbours(graph, points[points.size() - 2], v)) {
      points.pop_back();
    }
    points.push_back(v);
  }
  // The same where a closed line comes round.
  while (line.closed && points.size() > 3) {
    if (points.front() == points.back() || areNeighbours(graph, points[points.size() - 2], points.front())) {
      points.pop_back();
    }
    else if (areNeighbours(graph, points.back(), points[1])) {
      points.erase(points.begin());
    }
    else {
      break;
    }
  }
  line.closed = line.closed && points.size() > 2;
  line.points.swap(points);
}

double
length(const SurfaceGraph& graph, const Polyline& line)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    sum += edgeLength(graph, line.points[i - 1], line.points[i]);
  }
  return line.closed ? sum + edgeLength(graph, line.points.back(), line.points.front()) : sum;
}

/** Longest first, without the short ones. */
std::vector<Polyline>
longestFirst(const SurfaceGraph& graph, std::vector<Polyline>& lines)
{
  std::vector<double> lengths;
  lengths.reserve(lines.size());
  for (const Polyline& line : lines) {
    lengths.push_back(length(graph, line));
  }
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&lengths](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  std::vector<Polyline> sorted;
  for (const std::size_t i : order) {
    if (lines[i].points.size() > 1 && lengths[i] >= settings.shortest_share * lengths[order.front()]) {
      sorted.push_back(std::move(lines[i]));
    }
  }
  return sorted;
}

} // namespace

std::vector<Polyline>
traceAxis(const SurfaceGraph& graph,
          const std::vector<Triangle>& triangles,
          const std::vector<float>& side_function,
          const std::vector<Side>& sides)
{
  std::vector<Polyline> lines =
      triangles.empty() ? bandCurves(graph, side_function, sides) : zeroContours(triangles, side_function);
  for (Polyline& line : lines) {
    straighten(graph, line);
  }
  return longestFirst(graph, lines);
}

} // namespace symmetry
} // namespace pcl
