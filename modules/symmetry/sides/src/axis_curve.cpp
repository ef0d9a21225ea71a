#include "symmetry/sides/axis_curve.h"

#include "cloud/local_delaunay.h"
#include "symmetry/sides/curve_points.h"
#include "symmetry/sides/line_joining.h"
#include "symmetry/sides/mesh_contour.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr AxisSettings settings{};

/** Appends the nearer end of a crossed edge, over ends of both edges where it is no neighbour of that before. */
void
appendEnd(const SurfaceGraph& graph,
          const ZeroCrossing& before,
          const ZeroCrossing& crossing,
          std::vector<Index>& points)
{
  const Index next = crossing.nearerEnd();
  const auto are_joined = [&](Index a, Index b) {
    return a == b || areNeighbours(graph, a, b);
  };
  const Index last = points.back();
  for (const Index leave : {last, before.from, before.to}) {
    for (const Index enter : {next, crossing.from, crossing.to}) {
      if (are_joined(leave, enter)) {
        points.insert(points.end(), {leave, enter, next}); // repetitions are taken out below
        return;
      }
    }
  }
  points.push_back(next); // over a gap
}

/** Points along a line, with repetitions. */
std::vector<Index>
pointsAlong(const SurfaceGraph& graph, const ZeroLine& line)
{
  std::vector<Index> points{line.crossings.front().nearerEnd()};
  for (std::size_t i = 1; i < line.crossings.size(); ++i) {
    appendEnd(graph, line.crossings[i - 1], line.crossings[i], points);
  }
  if (line.closed) {
    appendEnd(graph, line.crossings.back(), line.crossings.front(), points);
  }
  return points;
}

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
  line.points.swap(points);
}

/** The stretches of lines that are not left out. */
std::vector<ZeroLine>
withoutParts(const std::vector<ZeroLine>& lines, const std::vector<char>& is_out)
{
  std::vector<ZeroLine> kept;
  const auto left_out = [&](const ZeroCrossing& crossing) {
    return is_out[crossing.nearerEnd()] != 0;
  };
  for (const ZeroLine& line : lines) {
    if (std::none_of(line.crossings.begin(), line.crossings.end(), left_out)) {
      kept.push_back(line);
      continue;
    }
    // One that is closed starts behind a part that is left out, so that no stretch is cut in two.
    std::vector<ZeroCrossing> crossings = line.crossings;
    if (line.closed) {
      std::rotate(crossings.begin(), std::find_if(crossings.begin(), crossings.end(), left_out), crossings.end());
    }
    bool started = false;
    for (const ZeroCrossing& crossing : crossings) {
      if (left_out(crossing)) {
        started = false;
        continue;
      }
      if (!started) {
        kept.push_back({});
        started = true;
      }
      kept.back().crossings.push_back(crossing);
    }
  }
  return kept;
}

/** Longest first, without those that are shorter than a share of the longest. */
std::vector<ZeroLine>
longestFirst(std::vector<ZeroLine> lines, const std::vector<Vector3>& points, float shortest_share)
{
  std::vector<float> lengths;
  lengths.reserve(lines.size());
  for (const ZeroLine& line : lines) {
    lengths.push_back(lengthOf(line, points));
  }
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  std::vector<ZeroLine> sorted;
  for (const std::size_t i : order) {
    if (lines[i].crossings.size() > 1 && lengths[i] >= shortest_share * lengths[order.front()]) {
      sorted.push_back(std::move(lines[i]));
    }
  }
  return sorted;
}

/** Of a cloud, around the points that have a neighbour on the other side. */
std::vector<Triangle>
trianglesBetweenSides(const PreparedSurface& cloud, const std::vector<float>& side_function)
{
  std::vector<Index> between;
  for (std::size_t v = 0; v < cloud.size(); ++v) {
    const auto& neighbours = cloud.graph.neighboursOf(v);
    if (std::any_of(neighbours.begin(), neighbours.end(),
                    [&](Index w) { return (side_function[v] < 0.0F) != (side_function[w] < 0.0F); })) {
      between.push_back(static_cast<Index>(v));
    }
  }
  return conformingTriangles(cloud.points, cloud.normals, cloud.graph, between);
}

} // namespace

std::vector<Polyline>
traceAxis(const PreparedSurface& surface,
          const std::vector<float>& side_function,
          const std::vector<char>& is_out,
          bool are_sides_exact)
{
  // Triangles of a cloud leave crumbs, however exact the sides are.
  const float shortest_share = are_sides_exact && !surface.is_cloud ? 0.0F : settings.shortest_share;
  const auto sorted = [&](std::vector<ZeroLine> lines) {
    return longestFirst(std::move(lines), surface.points, shortest_share);
  };
  std::vector<ZeroLine> zero_lines = sorted(zeroContours(
      surface.is_cloud ? trianglesBetweenSides(surface, side_function) : surface.triangles, side_function));
  if (surface.is_cloud) {
    zero_lines.resize(std::min(zero_lines.size(), settings.most_stretches));
    zero_lines = sorted(joinedLines(surface, side_function, std::move(zero_lines)));
  }
  if (!is_out.empty()) {
    zero_lines = sorted(withoutParts(zero_lines, is_out));
  }
  std::vector<Polyline> lines;
  for (const ZeroLine& zero_line : zero_lines) {
    Polyline line{pointsAlong(surface.graph, zero_line), zero_line.closed,
                  curvePoints(surface, side_function, zero_line)};
    straighten(surface.graph, line);
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace symmetry
} // namespace pcl
