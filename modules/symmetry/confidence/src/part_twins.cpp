#include "symmetry/confidence/part_twins.h"

#include "base/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Area around each point: a third of every triangle at it; of a cloud every point counts the same. */
std::vector<double>
areasOfPoints(const PreparedSurface& surface)
{
  if (surface.is_cloud) {
    return std::vector<double>(surface.size(), 1.0);
  }
  std::vector<double> areas(surface.size(), 0.0);
  for (const Triangle& t : surface.triangles) {
    const Vector3& a = surface.points[t[0]];
    const double doubled = norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
    for (const Index v : t) {
      areas[v] += doubled / 6.0;
    }
  }
  return areas;
}

/** What of a part stays the same when it is mirrored or moved. */
struct PartShape {
  double area = 0.0;
  std::array<double, 3> first{}; ///< moments
  double second = 0.0;

  double
  spread() const
  {
    double mean = 0.0;
    for (const double moment : first) {
      mean += (moment / area) * (moment / area);
    }
    return area > 0.0 ? std::sqrt(std::max(0.0, second / area - mean)) : 0.0;
  }
};

double
ratio(double a, double b)
{
  return std::max(a, b) > 0.0 ? std::min(a, b) / std::max(a, b) : 1.0;
}

} // namespace

float
shareOfTwinParts(const PreparedSurface& surface, const std::vector<Index>& partners)
{
  if (surface.part_of.empty()) {
    return 1.0F;
  }
  const std::vector<double> areas = areasOfPoints(surface);
  std::vector<PartShape> parts(
      1 + static_cast<std::size_t>(*std::max_element(surface.part_of.begin(), surface.part_of.end())));
  std::map<std::pair<Index, Index>, double> votes;
  double total = 0.0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    PartShape& part = parts[surface.part_of[v]];
    part.area += areas[v];
    total += areas[v];
    for (std::size_t k = 0; k < 3; ++k) {
      part.first[k] += areas[v] * double{surface.points[v][k]};
    }
    part.second += areas[v] * double{dot(surface.points[v], surface.points[v])};
    if (partners[v] != no_index) {
      votes[{surface.part_of[v], surface.part_of[partners[v]]}] += areas[v];
    }
  }
  std::vector<double> twins(parts.size(), 0.0); // area of each part that goes to its twin, times how alike they are
  for (const auto& [pair, area] : votes) {
    const PartShape& from = parts[pair.first];
    const PartShape& to = parts[pair.second];
    const double alike = ratio(from.area, to.area) * ratio(from.spread(), to.spread());
    twins[pair.first] = std::max(twins[pair.first], area * alike);
  }
  double sum = 0.0;
  for (const double twin : twins) {
    sum += twin;
  }
  return total > 0.0 ? static_cast<float>(sum / total) : 1.0F;
}

} // namespace symmetry
} // namespace pcl
