#include "symmetry/surface/prepared_surface.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

void
keepPoints(PreparedSurface& surface, const std::vector<char>& keep)
{
  std::vector<Index> new_number(surface.size(), no_index);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (keep[v] != 0) {
      new_number[v] = static_cast<Index>(kept);
      surface.points[kept] = surface.points[v];
      surface.original[kept] = surface.original[v];
      if (!surface.normals.empty()) {
        surface.normals[kept] = surface.normals[v];
      }
      ++kept;
    }
  }
  surface.points.resize(kept);
  surface.original.resize(kept);
  for (Index& representative : surface.representatives) {
    representative = representative == no_index ? no_index : new_number[representative];
  }
  if (!surface.normals.empty()) {
    surface.normals.resize(kept);
  }
  std::size_t faces = 0;
  for (const Triangle& t : surface.triangles) {
    const Triangle renumbered{new_number[t[0]], new_number[t[1]], new_number[t[2]]};
    if (renumbered[0] != no_index && renumbered[1] != no_index && renumbered[2] != no_index) {
      surface.triangles[faces++] = renumbered;
    }
  }
  surface.triangles.resize(faces);
}

std::size_t
countLeftOut(const PreparedSurface& surface)
{
  return static_cast<std::size_t>(std::count(surface.representatives.begin(), surface.representatives.end(), no_index));
}

} // namespace symmetry
} // namespace pcl
