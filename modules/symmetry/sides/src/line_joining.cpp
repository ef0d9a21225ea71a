#include "symmetry/sides/line_joining.h"

#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl {
namespace symmetry {
namespace {

constexpr LineJoiningSettings settings{};

/** One end of an open line. */
struct LineEnd {
  std::size_t line;
  bool at_back;
  ZeroCrossing crossing;
  Vector3 place;
};

/** Two ends that may belong together. */
struct Gap {
  LineEnd from;
  LineEnd to;
  float width;
};

std::vector<LineEnd>
openEnds(const std::vector<ZeroLine>& lines, const std::vector<Vector3>& points)
{
  std::vector<LineEnd> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].closed) {
      const std::vector<ZeroCrossing>& crossings = lines[i].crossings;
      ends.push_back({i, false, crossings.front(), placeOf(crossings.front(), points)});
      ends.push_back({i, true, crossings.back(), placeOf(crossings.back(), points)});
    }
  }
  return ends;
}

/** The narrowest first. */
std::vector<Gap>
findGaps(const std::vector<ZeroLine>& lines, const std::vector<Vector3>& points)
{
  const std::vector<LineEnd> ends = openEnds(lines, points);
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const float width = distance(ends[i].place, ends[j].place);
      const bool is_one_line = ends[i].line == ends[j].line;
      const float widest =
          is_one_line ? std::min(settings.widest, settings.widest_share * lengthOf(lines[ends[i].line], points))
                      : settings.widest;
      if (width <= widest) {
        gaps.push_back({ends[i], ends[j], width});
      }
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.width < b.width; });
  return gaps;
}

float
extent(const ZeroCrossing& crossing, const std::vector<Vector3>& points)
{
  return distance(points[crossing.from], points[crossing.to]);
}

/** Finds paths over the surface that keep to the zero of a function. */
class GapBridge {
public:
  GapBridge(const PreparedSurface& surface, const std::vector<float>& values)
      : surface_(surface), values_(values), number_(surface.size(), no_index)
  {
  }

  /** Points between two ends; nothing where the way is long or leads away from the zero. */
  std::optional<std::vector<Index>>
  across(const Gap& gap)
  {
    const Index start = gap.from.crossing.nearerEnd();
    const Index goal = gap.to.crossing.nearerEnd();
    const float edge = 0.5F * (extent(gap.from.crossing, surface_.points) + extent(gap.to.crossing, surface_.points));
    const float reach = gap.width + std::max(edge, settings.least);
    const float room = settings.detour * reach;
    std::vector<Index> around;
    for (std::size_t v = 0; v < surface_.size(); ++v) {
      const Vector3& p = surface_.points[v];
      if (distance(p, surface_.points[start]) + distance(p, surface_.points[goal]) <= room) {
        number_[v] = static_cast<Index>(around.size());
        around.push_back(static_cast<Index>(v));
      }
    }
    const std::vector<Index> path = shortestPath(penalized(around, edge), number_[start], number_[goal]);
    float length = 0.0F;
    std::vector<Index> points;
    for (const Index v : path) {
      length += points.empty() ? 0.0F : distance(surface_.points[points.back()], surface_.points[around[v]]);
      points.push_back(around[v]);
    }
    const bool strays = std::any_of(points.begin(), points.end(),
                                    [&](Index v) { return std::abs(values_[v]) > settings.stray * reach; });
    for (const Index v : around) {
      number_[v] = no_index;
    }
    if (points.empty() || strays || length > room) {
      return std::nullopt;
    }
    return points;
  }

private:
  /** The graph of some points; an edge counts as longer the farther it is from the zero, in edges. */
  SurfaceGraph
  penalized(const std::vector<Index>& around, float edge) const
  {
    std::vector<GraphEdge> edges;
    for (const Index v : around) {
      for (const auto [w, length] : surface_.graph.edges(v)) {
        if (v < w && number_[w] != no_index) {
          const float off = 0.5F * (std::abs(values_[v]) + std::abs(values_[w])) / std::max(edge, 1e-6F);
          edges.push_back({number_[v], number_[w], length * (1.0F + off * off)});
        }
      }
    }
    return buildGraph(around.size(), edges);
  }

  const PreparedSurface& surface_;
  const std::vector<float>& values_;
  std::vector<Index> number_; ///< scratch: of the points around a gap
};

/** The crossings of two lines in one, with the points of a path in between. */
void
join(const Gap& gap, const std::vector<Index>& path, std::vector<ZeroLine>& lines)
{
  std::vector<ZeroCrossing> between;
  between.reserve(path.size());
  for (const Index v : path) {
    between.push_back({v, v, 0.0F});
  }
  ZeroLine& first = lines[gap.from.line];
  if (gap.from.line == gap.to.line) { // from its front to its back
    first.crossings.insert(first.crossings.end(), between.rbegin(), between.rend());
    first.closed = true;
    return;
  }
  ZeroLine& second = lines[gap.to.line];
  if (!gap.from.at_back) {
    std::reverse(first.crossings.begin(), first.crossings.end());
  }
  if (gap.to.at_back) {
    std::reverse(second.crossings.begin(), second.crossings.end());
  }
  first.crossings.insert(first.crossings.end(), between.begin(), between.end());
  first.crossings.insert(first.crossings.end(), second.crossings.begin(), second.crossings.end());
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(gap.to.line));
}

} // namespace

float
lengthOf(const ZeroLine& line, const std::vector<Vector3>& points)
{
  float sum = 0.0F;
  for (std::size_t i = line.closed ? 0 : 1; i < line.crossings.size(); ++i) {
    const ZeroCrossing& before = i > 0 ? line.crossings[i - 1] : line.crossings.back();
    sum += distance(placeOf(before, points), placeOf(line.crossings[i], points));
  }
  return sum;
}

std::vector<ZeroLine>
joinedLines(const PreparedSurface& surface, const std::vector<float>& values, std::vector<ZeroLine> lines)
{
  GapBridge bridge(surface, values);
  bool joined = true;
  while (joined) {
    joined = false;
    for (const Gap& gap : findGaps(lines, surface.points)) {
      // Ends that all but meet are parted by what only touches, such as lips, or by a triangle that is missing.
      const float edge = 0.5F * (extent(gap.from.crossing, surface.points) + extent(gap.to.crossing, surface.points));
      const std::optional<std::vector<Index>> path =
          gap.width <= std::max(settings.least, edge) ? std::vector<Index>{} : bridge.across(gap);
      if (path) {
        join(gap, *path, lines);
        joined = true;
        break; // the numbers of lines have changed
      }
    }
  }
  return lines;
}

} // namespace symmetry
} // namespace pcl
