#include "symmetry/mirror/surface_distance.h"

#include "base/statistics.h"
#include "base/vector_math.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** The point of a triangle nearest to a place (C. Ericson, 2005 \cite ericson2005collision, section 5.1.5: by the
 * Voronoi region of the triangle that the place is in). */
Vector3
closestPoint(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const float d1 = dot(ab, p - a);
  const float d2 = dot(ac, p - a);
  if (d1 <= 0.0F && d2 <= 0.0F) {
    return a;
  }
  const float d3 = dot(ab, p - b);
  const float d4 = dot(ac, p - b);
  if (d3 >= 0.0F && d4 <= d3) {
    return b;
  }
  const float d5 = dot(ab, p - c);
  const float d6 = dot(ac, p - c);
  if (d6 >= 0.0F && d5 <= d6) {
    return c;
  }
  const float at_c = d1 * d4 - d3 * d2;
  if (at_c <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) {
    return a + (d1 / (d1 - d3)) * ab;
  }
  const float at_b = d5 * d2 - d1 * d6;
  if (at_b <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) {
    return a + (d2 / (d2 - d6)) * ac;
  }
  const float at_a = d3 * d6 - d5 * d4;
  if (at_a <= 0.0F && d4 >= d3 && d5 >= d6) {
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  }
  const float sum = at_a + at_b + at_c;
  return sum > 0.0F ? a + (at_b / sum) * ab + (at_c / sum) * ac : a;
}

std::vector<Vector3>
middlesOfTriangles(const PreparedSurface& surface)
{
  std::vector<Vector3> middles;
  for (const Triangle& t : surface.triangles) {
    middles.push_back((1.0F / 3.0F) * (surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]));
  }
  return middles;
}

std::vector<float>
radiiOfTriangles(const PreparedSurface& surface, const std::vector<Vector3>& middles)
{
  std::vector<float> radii;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    float radius = 0.0F;
    for (const Index v : surface.triangles[i]) {
      radius = std::max(radius, distance(middles[i], surface.points[v]));
    }
    radii.push_back(radius);
  }
  return radii;
}

/** How far all but a tenth of the neighbours of each point of a cloud are: so far its plane is taken to reach. */
std::vector<float>
farEdges(const SurfaceGraph& graph)
{
  std::vector<float> reaches;
  std::vector<float> lengths;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    lengths.assign(graph.lengths.begin() + graph.offsets[v], graph.lengths.begin() + graph.offsets[v + 1]);
    reaches.push_back(quantileInPlace(lengths, 0.9));
  }
  return reaches;
}

std::vector<float>
boundedBy(float largest, std::vector<float> values)
{
  std::transform(values.begin(), values.end(), values.begin(), [largest](float x) { return std::min(x, largest); });
  return values;
}

/** Surfaces are at unit scale, and long sides are split: wider triangles are slivers of which there were too many. They
 * are met around their middles only. */
constexpr float widest_radius = 0.06F;

} // namespace

SurfaceDistance::SurfaceDistance(const PreparedSurface& surface, float reach)
    : surface_(surface),
      reach_(reach),
      middles_(surface.is_cloud ? std::vector<Vector3>{} : middlesOfTriangles(surface)),
      radii_(surface.is_cloud ? farEdges(surface.graph) : radiiOfTriangles(surface, middles_)),
      tree_(surface.is_cloud ? surface.points : middles_, boundedBy(widest_radius, radii_))
{
}

SurfaceDistance::Nearest
SurfaceDistance::nearestOfPlane(Index point, const Vector3& place) const
{
  const Vector3 way = place - surface_.points[point];
  const float apart = norm(way);
  if (apart > radii_[point]) {
    return {surface_.points[point], apart};
  }
  const float height = dot(way, surface_.normals[point]);
  return {place - height * surface_.normals[point], std::abs(height)};
}

SurfaceDistance::Nearest
SurfaceDistance::nearestOfTriangle(Index triangle, const Vector3& place) const
{
  const Triangle& t = surface_.triangles[triangle];
  const Vector3 closest = closestPoint(place, surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
  return {closest, distance(place, closest)};
}

std::optional<SurfaceDistance::Nearest>
SurfaceDistance::nearest(const Vector3& place) const
{
  std::optional<Nearest> best;
  Index nearest = no_index;
  float least = reach_;
  const auto reach = [&](float radius) {
    return surface_.is_cloud ? std::max(radius, least) : radius + least;
  };
  tree_.visitNearest(place, reach, [&](Index i) {
    if (surface_.is_cloud || distance(middles_[i], place) <= least + radii_[i]) {
      const Nearest found = surface_.is_cloud ? nearestOfPlane(i, place) : nearestOfTriangle(i, place);
      if (found.distance < least || (found.distance == least && i > nearest)) {
        least = found.distance;
        best = found;
        nearest = i;
      }
    }
  });
  return best;
}

float
SurfaceDistance::at(const Vector3& place) const
{
  const std::optional<Nearest> found = nearest(place);
  return found ? found->distance : std::numeric_limits<float>::infinity();
}

} // namespace symmetry
} // namespace pcl
