#include "symmetry/surface/mesh_subdivision.h"

#include "base/union_find.h"
#include "base/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Two points, the lower first. */
using TriangleSide = std::pair<Index, Index>;

TriangleSide
sideOf(const Triangle& t, std::size_t k)
{
  return std::minmax(t[k], t[(k + 1) % 3]);
}

constexpr std::size_t points_of_a_shape = 60;   // as few as the robust method takes
constexpr std::size_t points_of_an_object = 16; // two boxes: how parts lie to each other is a shape
constexpr float side_of_fine_mesh = 4.0F;       // spacings: as far as samples reach

bool
hasSeveralParts(const PreparedSurface& surface)
{
  UnionFind parts(surface.size());
  std::size_t joined = 0;
  for (const Triangle& t : surface.triangles) {
    joined += parts.join(t[0], t[1]) ? 1U : 0U;
    joined += parts.join(t[1], t[2]) ? 1U : 0U;
  }
  return joined + 1 < surface.size();
}

std::vector<TriangleSide>
sidesLongerThan(const PreparedSurface& surface, float longest)
{
  std::vector<TriangleSide> sides;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (distance(surface.points[t[k]], surface.points[t[(k + 1) % 3]]) > longest) {
        sides.push_back(sideOf(t, k));
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

/** Adds the middle of a side. Of the points of the input that its ends stand for, the nearer one is told what is there. */
void
addMiddle(PreparedSurface& surface, const TriangleSide& side)
{
  const Vector3 a = surface.points[side.first];
  const Vector3 b = surface.points[side.second];
  const Vector3 middle = 0.5F * (a + b);
  const Index of_a = surface.original[side.first];
  const Index of_b = surface.original[side.second];
  const auto way_to = [&](Index input) {
    return distance(middle, surface.points[surface.representatives[input]]);
  };
  surface.original.push_back(way_to(of_a) <= way_to(of_b) ? of_a : of_b);
  surface.points.push_back(middle);
}

/** Cuts a triangle at the middles of its sides that have one: into two, three (the quadrilateral along its shorter
 * diagonal) or four. */
void
cutTriangle(const std::vector<Vector3>& points,
            const Triangle& t,
            const std::array<Index, 3>& middles,
            std::vector<Triangle>& to)
{
  const auto is_split = [&](std::size_t k) {
    return middles[k % 3] != no_index;
  };
  const auto count = static_cast<std::size_t>(
      std::count_if(middles.begin(), middles.end(), [](Index middle) { return middle != no_index; }));
  if (count == 0) {
    to.push_back(t);
    return;
  }
  if (count == 3) {
    to.push_back({t[0], middles[0], middles[2]});
    to.push_back({t[1], middles[1], middles[0]});
    to.push_back({t[2], middles[2], middles[1]});
    to.push_back(middles);
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = t[k];
    const Index b = t[(k + 1) % 3];
    const Index c = t[(k + 2) % 3];
    if (count == 1 && is_split(k)) { // of the side from a to b
      to.push_back({a, middles[k], c});
      to.push_back({middles[k], b, c});
    }
    else if (count == 2 && is_split(k) && is_split(k + 1)) { // of both sides at b
      const Index ab = middles[k];
      const Index bc = middles[(k + 1) % 3];
      to.push_back({ab, b, bc});
      if (distance(points[a], points[bc]) <= distance(points[ab], points[c])) {
        to.push_back({a, ab, bc});
        to.push_back({a, bc, c});
      }
      else {
        to.push_back({a, ab, c});
        to.push_back({ab, bc, c});
      }
    }
  }
}

} // namespace

float
evenSpacing(const PreparedSurface& surface, std::size_t points)
{
  double area = 0.0;
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    area += 0.5 * norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
  }
  return static_cast<float>(std::sqrt(2.0 * area / (std::sqrt(3.0) * static_cast<double>(points))));
}

std::size_t
splitLongSides(PreparedSurface& surface, std::size_t wanted)
{
  const std::size_t before = surface.size();
  const std::size_t most = before + 4 * wanted; // slivers would take more
  const bool is_in_parts = hasSeveralParts(surface);
  const bool is_coarse = 2 * before < wanted || is_in_parts;
  const float longest =
      surface.triangles.empty() ? 0.0F : (is_coarse ? 1.0F : side_of_fine_mesh) * evenSpacing(surface, wanted);
  if (!(longest > 0.0F) || before < (is_in_parts ? points_of_an_object : points_of_a_shape)) {
    return 0;
  }
  std::vector<Triangle> unsplit = surface.triangles;
  for (;;) {
    const std::vector<TriangleSide> sides = sidesLongerThan(surface, longest);
    if (sides.empty() || surface.size() + sides.size() > most) {
      break;
    }
    const auto first = static_cast<Index>(surface.size());
    std::for_each(sides.begin(), sides.end(), [&](const TriangleSide& side) { addMiddle(surface, side); });
    std::vector<Triangle> cut;
    cut.reserve(surface.triangles.size() + 2 * sides.size());
    for (const Triangle& t : surface.triangles) {
      std::array<Index, 3> middles{no_index, no_index, no_index};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = std::lower_bound(sides.begin(), sides.end(), sideOf(t, k));
        if (found != sides.end() && *found == sideOf(t, k)) {
          middles[k] = first + static_cast<Index>(found - sides.begin());
        }
      }
      cutTriangle(surface.points, t, middles, cut);
    }
    surface.triangles = std::move(cut);
  }
  if (surface.size() > before) {
    surface.unsplit = std::move(unsplit);
  }
  return surface.size() - before;
}

} // namespace symmetry
} // namespace pcl
