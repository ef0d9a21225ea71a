#include "cloud/merged_sheets.h"

#include "base/heartbeat.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr SheetSettings settings{};

/** How far it is to the outside in a direction; infinite if farther than \a reach. */
float
wayOut(const OutsideSpace& outside, const Vector3& place, const Vector3& direction, float reach)
{
  const float step = settings.probe_step * outside.cube();
  const auto steps = static_cast<int>(reach / step);
  for (int i = 1; i <= steps; ++i) {
    const float way = static_cast<float>(i) * step;
    if (outside.contains(place + way * direction)) {
      return way;
    }
  }
  return std::numeric_limits<float>::infinity();
}

/** \param[in,out] normal turned outwards where that can be told */
Sides
lookAround(const OutsideSpace& outside, const Vector3& place, Vector3& normal)
{
  const float reach = settings.reach * outside.cube();
  const float ahead = wayOut(outside, place, normal, reach);
  const float behind = wayOut(outside, place, -1.0F * normal, reach);
  if (ahead > reach && behind > reach) {
    return Sides::Inside;
  }
  if (behind < ahead) {
    normal = -1.0F * normal;
  }
  const float doubt = settings.doubt * outside.cube();
  return std::max(ahead, behind) > std::min(ahead, behind) + doubt ? Sides::Outside : Sides::Alike;
}

} // namespace

LayerSides
lookToBothSides(const std::vector<Surfel>& surface,
                const std::vector<Vector3>& places,
                std::vector<Vector3> normals,
                float spacing)
{
  LayerSides layers;
  layers.normals = std::move(normals);
  if (!(spacing > 0.0F)) { // nothing but points at the same place as their neighbours
    return layers;
  }
  float last = 0.0F; // where the space is too large for cubes of a size, several sizes come out as one
  for (int view = 0; view < settings.views; ++view) {
    const float cube = (settings.finest_cube + static_cast<float>(view) * settings.cube_step) * spacing;
    if (cube <= last) {
      continue;
    }
    const OutsideSpace outside(surface, cube);
    last = outside.cube();
    std::vector<Sides> sides;
    for (std::size_t i = 0; i < places.size(); ++i) {
      heartbeat();
      sides.push_back(lookAround(outside, places[i], layers.normals[i]));
    }
    const auto open = static_cast<float>(std::count(sides.begin(), sides.end(), Sides::Alike));
    if (open <= (1.0F - settings.closed) * static_cast<float>(places.size())) {
      layers.sides = std::move(sides);
      layers.clearance = outside.cube();
      break;
    }
  }
  return layers;
}

NeighbourLists
neighboursOnOwnSheet(const NeighbourLists& lists, const std::vector<Vector3>& normals, std::size_t k)
{
  NeighbourLists own;
  own.k = k;
  own.neighbours.assign(normals.size() * k, no_index);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    std::size_t found = 0;
    for (const Index u : lists.of(v)) {
      if (found < k && dot(normals[v], normals[u]) > settings.opposed) {
        own.neighbours[v * k + found++] = u;
      }
    }
  }
  return own;
}

} // namespace symmetry
} // namespace pcl
