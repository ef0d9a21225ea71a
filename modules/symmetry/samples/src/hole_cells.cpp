#include "symmetry/samples/hole_cells.h"

#include "base/bounding_box.h"
#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "symmetry/samples/sample_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr HoleSettings settings{};

/** How a point lies: in the surface, perhaps on a rim, or surely. */
enum class Place : char { Inside, PerhapsOnRim, OnRim };

/** Where triangles close around a point, each of its neighbours is in two of them: their numbers cancel out. */
std::vector<Place>
placesOnMesh(const PreparedSurface& surface)
{
  std::vector<Index> unpaired(surface.size(), 0);
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      unpaired[t[k]] ^= t[(k + 1) % 3] ^ t[(k + 2) % 3];
    }
  }
  std::vector<Place> places(surface.size());
  std::transform(unpaired.begin(), unpaired.end(), places.begin(),
                 [](Index rest) { return rest != 0 ? Place::OnRim : Place::Inside; });
  return places;
}

/** Widest angle between the directions of neighbours that follow each other around a point, in its tangent plane. */
float
widestGap(const PreparedSurface& surface, std::size_t v, std::vector<float>& angles)
{
  constexpr float full_turn = 6.2831853F;
  const auto [axis_x, axis_y] = tangentFrame(surface.normals[v]);
  angles.clear();
  for (const Index w : surface.graph.neighboursOf(v)) {
    const Vector3 offset = surface.points[w] - surface.points[v];
    angles.push_back(std::atan2(dot(offset, axis_y), dot(offset, axis_x)));
  }
  if (angles.empty()) {
    return full_turn;
  }
  std::sort(angles.begin(), angles.end());
  float widest = angles.front() + full_turn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    widest = std::max(widest, angles[i] - angles[i - 1]);
  }
  return widest;
}

std::vector<Place>
placesInCloud(const PreparedSurface& surface)
{
  std::vector<Place> places(surface.size());
  std::vector<float> angles;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const float gap = widestGap(surface, v, angles);
    places[v] = gap > settings.rim_gap        ? Place::OnRim
                : gap > settings.possible_gap ? Place::PerhapsOnRim
                                              : Place::Inside;
  }
  return places;
}

/** What hangs together with a point on a rim and perhaps is on it, too; moved inside, so that it is taken once. */
std::vector<Index>
takeRim(const SurfaceGraph& graph, Index start, std::vector<Place>& places)
{
  std::vector<Index> rim{start};
  places[start] = Place::Inside;
  for (std::size_t i = 0; i < rim.size(); ++i) { // grows while it is worked off
    for (std::uint32_t e = graph.offsets[rim[i]]; e < graph.offsets[rim[i] + 1]; ++e) {
      const Index neighbour = graph.neighbours[e];
      if (places[neighbour] != Place::Inside) {
        places[neighbour] = Place::Inside;
        rim.push_back(neighbour);
      }
    }
  }
  return rim;
}

/** Diagonal of the bounding box. */
float
extentOf(const std::vector<Vector3>& points, const std::vector<Index>& members)
{
  BoundingBox box;
  for (const Index v : members) {
    box.extend(points[v]);
  }
  return distance(box.low, box.high);
}

} // namespace

std::vector<char>
cellsAtHoles(const PreparedSurface& surface, const FarthestPointSamples& cells, float spacing)
{
  std::vector<char> at_hole(cells.vertices.size(), 0);
  if (surface.summary.smoothing_radius > 0.0F) {
    return at_hole; // what smoothing leaves of noise has rims all over
  }
  std::vector<Place> places = surface.is_cloud ? placesInCloud(surface) : placesOnMesh(surface);
  const float minimum_extent = (surface.is_cloud ? settings.cloud_crack : settings.mesh_crack) * spacing;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (places[v] != Place::OnRim) {
      continue;
    }
    const std::vector<Index> rim = takeRim(surface.graph, static_cast<Index>(v), places);
    const float extent = extentOf(surface.points, rim);
    if (extent >= minimum_extent && extent <= settings.whole_side) {
      for (const Index w : rim) {
        at_hole[cells.owner[w]] = 1;
      }
    }
  }
  return at_hole;
}

} // namespace symmetry
} // namespace pcl
