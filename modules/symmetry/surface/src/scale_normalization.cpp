#include "symmetry/surface/scale_normalization.h"

#include "base/bounding_box.h"
#include "base/union_find.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace symmetry {
namespace {

/** Box of a mesh's largest component, since the others take no part; points that no face uses do not either. */
BoundingBox
boxOfLargestComponent(const PreparedSurface& surface)
{
  UnionFind components(surface.size());
  for (const Triangle& t : surface.triangles) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
  }
  const Index largest = components.largest();
  BoundingBox box;
  for (const Triangle& t : surface.triangles) {
    if (components.find(t[0]) == largest) {
      std::for_each(t.begin(), t.end(), [&](Index v) { box.extend(surface.points[v]); });
    }
  }
  return box;
}

/** Moves and scales points so that a box is centred at the origin and its longest side is 1; returns the scale. */
float
fitIntoUnitBox(const BoundingBox& box, std::vector<Vector3>& points)
{
  const double extent = box.longestSide();
  const double scale = extent > 0.0 ? 1.0 / extent : 1.0;
  const std::array<double, 3> centre = box.centre();
  for (Vector3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = static_cast<float>((p[k] - centre[k]) * scale);
    }
  }
  return static_cast<float>(scale);
}

} // namespace

void
normalizeScale(PreparedSurface& surface)
{
  const BoundingBox box = surface.triangles.empty() ? boundingBox(surface.points) : boxOfLargestComponent(surface);
  surface.scale = fitIntoUnitBox(box, surface.points);
  surface.centre = box.centre();
}

void
renormalizeScale(PreparedSurface& surface)
{
  const BoundingBox box = boundingBox(surface.points);
  const std::array<double, 3> shift = box.centre();
  for (std::size_t k = 0; k < 3; ++k) {
    surface.centre[k] += shift[k] / double{surface.scale};
  }
  const float factor = fitIntoUnitBox(box, surface.points);
  surface.scale *= factor;
  for (float& length : surface.graph.lengths) {
    length *= factor;
  }
}

} // namespace symmetry
} // namespace pcl
