#include "symmetry/surface/mesh_cleaning.h"

#include "base/coincident_points.h"
#include "base/renumbering.h"
#include "base/union_find.h"
#include "base/vector_math.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pcl {
namespace symmetry {

std::size_t
letStandForOthers(PreparedSurface& surface, const std::vector<Index>& first)
{
  std::vector<char> keep(surface.size());
  for (std::size_t v = 0; v < keep.size(); ++v) {
    keep[v] = static_cast<char>(first[v] == static_cast<Index>(v));
  }
  const auto others = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  if (others > 0) {
    renumber(surface.representatives, first);
    renumberTriangles(surface.triangles, first);
    keepPoints(surface, keep);
  }
  return others;
}

std::size_t
mergeRepeatedPoints(PreparedSurface& surface)
{
  return letStandForOthers(surface, firstCoincident(surface.points));
}

void
dropDegenerateTriangles(std::vector<Triangle>& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
                  triangles.end());
}

void
dropRepeatedTriangles(std::size_t n, std::vector<Triangle>& triangles)
{
  struct Corners {
    Index middle;
    Index highest;
    std::size_t triangle;
  };
  std::vector<Triangle> sorted = triangles;
  std::vector<std::size_t> offsets(n + 1, 0);
  for (Triangle& t : sorted) {
    std::sort(t.begin(), t.end());
    ++offsets[static_cast<std::size_t>(t[0]) + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());

  // Grouped by the lowest corner and in order within each group, what is equal stands side by side, the first in front.
  std::vector<Corners> corners(triangles.size());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    corners[next[sorted[i][0]]++] = {sorted[i][1], sorted[i][2], i};
  }
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(offsets[v]);
    const auto end = corners.begin() + static_cast<std::ptrdiff_t>(offsets[v + 1]);
    std::sort(begin, end, [](const Corners& x, const Corners& y) {
      return std::tie(x.middle, x.highest, x.triangle) < std::tie(y.middle, y.highest, y.triangle);
    });
    for (auto it = begin; it != end; ++it) {
      repeated[it->triangle] =
          static_cast<char>(it != begin && it->middle == (it - 1)->middle && it->highest == (it - 1)->highest);
    }
  }

  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (repeated[i] == 0) {
      triangles[kept++] = triangles[i];
    }
  }
  triangles.resize(kept);
}

void
dropUnusedPoints(PreparedSurface& surface)
{
  std::vector<char> is_used(surface.size(), 0);
  for (const Triangle& t : surface.triangles) {
    std::for_each(t.begin(), t.end(), [&](Index v) { is_used[v] = 1; });
  }
  if (std::find(is_used.begin(), is_used.end(), 0) == is_used.end()) {
    return;
  }
  const std::size_t before = countLeftOut(surface);
  keepPoints(surface, is_used);
  surface.summary.unused += countLeftOut(surface) - before;
}

void
keepLargestComponent(PreparedSurface& surface)
{
  UnionFind components(surface.size());
  for (const Triangle& t : surface.triangles) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
  }
  std::vector<double> areas(surface.size(), 0.0); // at the lowest point of each component
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    areas[components.find(t[0])] += norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
  }
  const auto largest = static_cast<Index>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  std::vector<char> keep(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Index component = components.find(static_cast<Index>(v));
    keep[v] = static_cast<char>(component == largest);
    surface.summary.components += component == static_cast<Index>(v) && component != largest ? 1U : 0U;
  }
  const std::size_t before = countLeftOut(surface);
  keepPoints(surface, keep);
  surface.summary.other_components += countLeftOut(surface) - before;
}

std::vector<Vector3>
vertexNormals(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 0.0F});
  for (const Triangle& t : triangles) {
    const Vector3 doubled_area = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for (const Index v : t) {
      normals[v] = normals[v] + doubled_area;
    }
  }
  for (Vector3& n : normals) {
    n = normalized(n);
  }
  return normals;
}

} // namespace symmetry
} // namespace pcl
