#include "symmetry/surface/limb.h"

#include "base/renumbering.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/surface/point_areas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** How much area lies within each distance of a point. */
class AreaWithin {
public:
  AreaWithin(const std::vector<float>& distances, const std::vector<float>& areas)
  {
    std::vector<Index> order(distances.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return distances[a] < distances[b]; });
    double sum = 0.0;
    for (const Index v : order) {
      sum += areas[v];
      distances_.push_back(distances[v]);
      areas_.push_back(static_cast<float>(sum));
    }
  }

  float
  at(float distance) const
  {
    const auto above = std::upper_bound(distances_.begin(), distances_.end(), distance) - distances_.begin();
    return above == 0 ? 0.0F : areas_[static_cast<std::size_t>(above - 1)];
  }

  float
  total() const
  {
    return areas_.back();
  }

private:
  std::vector<float> distances_; ///< ascending
  std::vector<float> areas_;
};

/** A curve around a limb. */
struct Cut {
  float distance; ///< from the end of the limb
  float girth;
  float area;
  float ratio; ///< isoperimetric
};

/** Curves up to half of the area, from the end on. */
std::vector<Cut>
cutsAround(const AreaWithin& area, std::size_t samples)
{
  constexpr float largest_share = 0.5F;
  constexpr float half_width = 3.0F; // spacings
  const float spacing = std::sqrt(area.total() / static_cast<float>(samples));
  const float before = half_width * spacing;
  std::vector<Cut> cuts;
  for (float distance = before; area.at(distance) <= largest_share * area.total(); distance += 0.5F * spacing) {
    const float girth = (area.at(distance + before) - area.at(distance - before)) / (2.0F * before);
    const float within = area.at(distance);
    if (within > 0.0F) {
      cuts.push_back({distance, girth, within, girth * girth / within});
    }
  }
  return cuts;
}

/** The part of a graph between the points that are kept. */
SurfaceGraph
graphBetween(const SurfaceGraph& graph, const std::vector<Index>& kept, const std::vector<Index>& numbers)
{
  SurfaceGraph between;
  for (const Index v : kept) {
    for (const auto [w, length] : graph.edges(v)) {
      if (numbers[w] != no_index) {
        between.neighbours.push_back(numbers[w]);
        between.lengths.push_back(length);
      }
    }
    between.offsets.push_back(static_cast<std::uint32_t>(between.neighbours.size()));
  }
  return between;
}

} // namespace

std::optional<Limb>
findLimb(const PreparedSurface& surface, Index end, std::size_t samples)
{
  constexpr float noise = 1.25F; // of a ratio: a length is known to a tenth
  if (surface.triangles.empty()) {
    return std::nullopt;
  }
  Limb limb;
  limb.end = end;
  limb.distances = distanceField(surface.graph, end);
  const AreaWithin area(limb.distances, pointAreas(surface));
  const std::vector<Cut> cuts = cutsAround(area, samples);
  const auto narrowest =
      std::min_element(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.ratio < b.ratio; });
  if (narrowest == cuts.end()) {
    return std::nullopt;
  }
  const float limit = noise * narrowest->ratio;
  const auto beyond = std::find_if(narrowest, cuts.end(), [limit](const Cut& c) { return c.ratio > limit; });
  if (beyond == cuts.end()) {
    return std::nullopt;
  }
  const auto root = std::prev(beyond);
  limb.root = root->distance;
  limb.girth = root->girth;
  limb.share = root->area / area.total();
  return limb;
}

PartOfSurface
withoutLimb(const PreparedSurface& surface, const Limb& limb)
{
  std::vector<char> keep(surface.size());
  for (std::size_t v = 0; v < keep.size(); ++v) {
    keep[v] = static_cast<char>(!limb.holds(static_cast<Index>(v)));
  }
  const std::vector<Index> outside = keptPoints(keep);
  const Components components = connectedComponents(graphBetween(surface.graph, outside, numbersOfKept(keep)));
  for (std::size_t i = 0; i < outside.size(); ++i) {
    keep[outside[i]] = static_cast<char>(components.component_of[i] == 0);
  }
  PartOfSurface rest{surface, keptPoints(keep)};
  keepPoints(rest.surface, keep);
  rest.surface.graph = graphBetween(surface.graph, rest.points, numbersOfKept(keep));
  return rest;
}

} // namespace symmetry
} // namespace pcl
