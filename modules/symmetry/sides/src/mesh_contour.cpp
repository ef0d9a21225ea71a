#include "symmetry/sides/mesh_contour.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** One passage of a line through a triangle: it enters and leaves through these two edges. */
struct Crossing {
  std::array<std::size_t, 2> edges;
};

/** The crossed edges and the passages between them: a graph of lines. */
struct ContourGraph {
  std::vector<std::array<Index, 2>> edges; ///< lower vertex first, ascending
  std::vector<Crossing> crossings;
  std::vector<std::vector<std::size_t>> crossings_of; ///< per edge
};

ContourGraph
findCrossings(const std::vector<Triangle>& triangles, const std::vector<float>& values)
{
  const auto crossed = [&values](Index a, Index b) {
    return (values[a] < 0.0F) != (values[b] < 0.0F);
  };
  ContourGraph contours;
  std::vector<std::array<Index, 2>> sides_crossed; // two per triangle that is crossed
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      if (crossed(a, b)) {
        sides_crossed.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
  contours.edges = sides_crossed;
  std::sort(contours.edges.begin(), contours.edges.end());
  contours.edges.erase(std::unique(contours.edges.begin(), contours.edges.end()), contours.edges.end());

  const auto number = [&contours](const std::array<Index, 2>& edge) {
    const auto found = std::lower_bound(contours.edges.begin(), contours.edges.end(), edge);
    return static_cast<std::size_t>(found - contours.edges.begin());
  };
  contours.crossings_of.resize(contours.edges.size());
  for (std::size_t i = 0; i + 1 < sides_crossed.size(); i += 2) {
    const Crossing crossing{{number(sides_crossed[i]), number(sides_crossed[i + 1])}};
    contours.crossings_of[crossing.edges[0]].push_back(contours.crossings.size());
    contours.crossings_of[crossing.edges[1]].push_back(contours.crossings.size());
    contours.crossings.push_back(crossing);
  }
  return contours;
}

/** Follows lines; every crossing is walked once. */
class ContourWalk {
public:
  ContourWalk(const ContourGraph& contours, const std::vector<float>& values)
      : contours_(contours), values_(values), walked_(contours.crossings.size(), false)
  {
  }

  bool
  walked(std::size_t crossing) const
  {
    return walked_[crossing];
  }

  ZeroLine
  walk(std::size_t start_edge, std::size_t crossing)
  {
    ZeroLine line;
    line.crossings.push_back(crossingOf(start_edge));
    std::size_t edge = start_edge;
    while (true) {
      walked_[crossing] = true;
      const Crossing& passage = contours_.crossings[crossing];
      edge = passage.edges[0] == edge ? passage.edges[1] : passage.edges[0];
      if (edge == start_edge) {
        line.closed = true;
        return line;
      }
      line.crossings.push_back(crossingOf(edge));
      const std::vector<std::size_t>& ways = contours_.crossings_of[edge];
      if (ways.size() != 2) {
        return line; // boundary, or an edge that more than two triangles share
      }
      crossing = ways[0] == crossing ? ways[1] : ways[0];
      if (walked_[crossing]) {
        return line;
      }
    }
  }

private:
  ZeroCrossing
  crossingOf(std::size_t edge) const
  {
    const auto [a, b] = contours_.edges[edge];
    return crossingBetween(a, b, values_);
  }

  const ContourGraph& contours_;
  const std::vector<float>& values_;
  std::vector<bool> walked_;
};

} // namespace

Vector3
placeOf(const ZeroCrossing& crossing, const std::vector<Vector3>& points)
{
  const Vector3& from = points[crossing.from];
  return from + crossing.share * (points[crossing.to] - from);
}

ZeroCrossing
crossingBetween(Index a, Index b, const std::vector<float>& values)
{
  const float sum = std::abs(values[a]) + std::abs(values[b]);
  return {a, b, sum > 0.0F ? std::abs(values[a]) / sum : 0.5F};
}

std::vector<ZeroLine>
zeroContours(const std::vector<Triangle>& triangles, const std::vector<float>& values)
{
  const ContourGraph contours = findCrossings(triangles, values);
  ContourWalk walk(contours, values);
  std::vector<ZeroLine> lines;
  // Lines with ends first, from their ends; what is left then are closed ones.
  for (std::size_t edge = 0; edge < contours.edges.size(); ++edge) {
    if (contours.crossings_of[edge].size() != 2) {
      for (const std::size_t crossing : contours.crossings_of[edge]) {
        if (!walk.walked(crossing)) {
          lines.push_back(walk.walk(edge, crossing));
        }
      }
    }
  }
  for (std::size_t crossing = 0; crossing < contours.crossings.size(); ++crossing) {
    if (!walk.walked(crossing)) {
      lines.push_back(walk.walk(contours.crossings[crossing].edges[0], crossing));
    }
  }
  return lines;
}

} // namespace symmetry
} // namespace pcl
