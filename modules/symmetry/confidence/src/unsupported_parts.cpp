#include "symmetry/confidence/unsupported_parts.h"

#include "geodesic/marked_groups.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/surface/point_areas.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {

void
dropSmallParts(const PreparedSurface& surface, float least_share, std::vector<char>& is_unsupported)
{
  UnionFind groups = markedGroups(surface.graph, is_unsupported);
  const std::vector<float> areas = pointAreas(surface);
  std::vector<double> of_group(surface.size(), 0.0);
  double all = 0.0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    all += areas[v];
    of_group[groups.find(static_cast<Index>(v))] += areas[v];
  }
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (of_group[groups.find(static_cast<Index>(v))] < double{least_share} * all) {
      is_unsupported[v] = 0;
    }
  }
}

float
shareWithPartner(const PreparedSurface& surface, const std::vector<Index>& partners)
{
  const std::vector<float> areas = pointAreas(surface);
  double all = 0.0;
  double mapped = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    all += areas[v];
    mapped += partners[v] == no_index ? 0.0 : areas[v];
  }
  return all > 0.0 ? static_cast<float>(mapped / all) : 0.0F;
}

std::vector<UnsupportedPart>
unsupportedParts(const PreparedSurface& surface, const std::vector<char>& is_unsupported)
{
  UnionFind groups = markedGroups(surface.graph, is_unsupported);
  std::vector<Index> supported;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (is_unsupported[v] == 0) {
      supported.push_back(static_cast<Index>(v));
    }
  }
  const std::vector<float> from_supported = distanceField(surface.graph, supported);
  const std::vector<float> areas = pointAreas(surface);
  std::vector<UnsupportedPart> by_group(surface.size());
  double all = 0.0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    all += areas[v];
    if (is_unsupported[v] == 0) {
      continue;
    }
    UnsupportedPart& part = by_group[groups.find(static_cast<Index>(v))];
    ++part.points;
    part.share += areas[v];
    if (std::isfinite(from_supported[v]) && (part.extreme == no_index || from_supported[v] > part.extent)) {
      part.extent = from_supported[v];
      part.extreme = static_cast<Index>(v);
    }
  }
  std::vector<UnsupportedPart> parts;
  std::copy_if(by_group.begin(), by_group.end(), std::back_inserter(parts),
               [](const UnsupportedPart& part) { return part.points > 0 && part.extreme != no_index; });
  for (UnsupportedPart& part : parts) {
    part.share = all > 0.0 ? part.share / static_cast<float>(all) : 0.0F;
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const UnsupportedPart& a, const UnsupportedPart& b) { return a.share > b.share; });
  return parts;
}

} // namespace symmetry
} // namespace pcl
