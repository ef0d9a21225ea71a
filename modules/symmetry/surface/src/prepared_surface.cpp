#include "symmetry/surface/prepared_surface.h"

#include "base/renumbering.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

void
keepPoints(PreparedSurface& surface, const std::vector<char>& keep)
{
  const std::vector<Index> numbers = numbersOfKept(keep);
  const std::vector<Index> kept = keptPoints(keep);
  keepEntries(surface.points, kept);
  keepEntries(surface.original, kept);
  if (!surface.normals.empty()) {
    keepEntries(surface.normals, kept);
  }
  if (!surface.part_of.empty()) {
    keepEntries(surface.part_of, kept);
  }
  renumber(surface.representatives, numbers);
  renumberTriangles(surface.triangles, numbers);
  renumberTriangles(surface.unsplit, numbers);
}

std::size_t
countLeftOut(const PreparedSurface& surface)
{
  return static_cast<std::size_t>(std::count(surface.representatives.begin(), surface.representatives.end(), no_index));
}

} // namespace symmetry
} // namespace pcl
