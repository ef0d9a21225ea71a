#include "symmetry/surface/point_areas.h"

#include "base/vector_math.h"

namespace pcl {
namespace symmetry {

std::vector<float>
pointAreas(const PreparedSurface& surface)
{
  std::vector<float> areas(surface.size(), surface.triangles.empty() ? 1.0F : 0.0F);
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    const float area = norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a)) / 6.0F;
    for (const Index v : t) {
      areas[v] += area;
    }
  }
  return areas;
}

} // namespace symmetry
} // namespace pcl
