#include "symmetry/mirror/mirror_map.h"

#include "base/parallel.h"
#include "cloud/ball_tree.h"
#include "cloud/point_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Finds the points nearest to places, by distance and by how a normal agrees with a direction up to sign. */
class NearestPoints {
public:
  NearestPoints(const PreparedSurface& surface, float reach)
      : surface_(surface), reach_(reach), grid_(surface.points, reach)
  {
    if (uncrowdedCell(surface.points, reach, most_around) < reach) {
      crowd_.emplace(surface.points, std::vector<float>(surface.size(), 0.0F));
    }
  }

  /** \param[in] part that the point must be of, no_index: any */
  Index
  find(const Vector3& place, const Vector3& direction, Index part) const
  {
    // A normal across the direction counts like half of the reach: on a thin sheet it decides, else places do.
    const float across = 0.5F * reach_;
    Index best = no_index;
    float least = 2.0F * reach_;
    const auto look_at = [&](Index v) {
      const float apart = distance(surface_.points[v], place);
      if (apart <= reach_ && (part == no_index || surface_.part_of[v] == part)) {
        const float cost = apart + across * (1.0F - std::abs(dot(surface_.normals[v], direction)));
        if (cost < least) {
          least = cost;
          best = v;
        }
      }
    };
    if (crowd_) {
      // No point costs less than it is apart.
      crowd_->visitNearest(
          place, [&](float) { return std::min(least, reach_); }, look_at);
    }
    else {
      grid_.visitAround(place, look_at);
    }
    return best;
  }

private:
  static constexpr std::size_t most_around = 1000; // a surface has some tens

  const PreparedSurface& surface_;
  float reach_;
  PointGrid grid_;
  std::optional<BallTree> crowd_; ///< where cubes hold so many points that looking at all of them would not end
};

/** The part that each part is mapped onto; no_index where its images lie on several or on none. */
std::vector<Index>
twinsOfParts(const PreparedSurface& surface, const std::vector<Index>& partners)
{
  const Index parts = 1 + *std::max_element(surface.part_of.begin(), surface.part_of.end());
  std::vector<std::size_t> sizes(parts, 0);
  std::map<std::pair<Index, Index>, std::size_t> votes;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    ++sizes[surface.part_of[v]];
    if (partners[v] != no_index) {
      ++votes[{surface.part_of[v], surface.part_of[partners[v]]}];
    }
  }
  std::vector<Index> twins(parts, no_index);
  std::vector<std::size_t> most(parts, 0);
  for (const auto& [pair, count] : votes) {
    if (2 * count >= sizes[pair.first] && count > most[pair.first]) {
      most[pair.first] = count;
      twins[pair.first] = pair.second;
    }
  }
  return twins;
}

} // namespace

MirrorMap
mapByMirror(const PreparedSurface& surface, const PlaneReflection& plane, float tolerance, float reach)
{
  constexpr std::size_t grain = 256;
  MirrorMap map{std::vector<Index>(surface.size(), no_index), std::vector<float>(surface.size(), reach)};
  const auto search = [&](const NearestPoints& nearest, const std::vector<Index>& twins) {
    parallelFor(
        surface.size(),
        [&](std::size_t v) {
          if (map.partners[v] == no_index) {
            const Index twin = twins.empty() ? no_index : twins[surface.part_of[v]];
            map.partners[v] = nearest.find(plane.image(surface.points[v]), plane.turned(surface.normals[v]), twin);
          }
        },
        grain);
  };
  const NearestPoints close(surface, tolerance);
  search(close, {});
  std::vector<Index> twins;
  if (!surface.part_of.empty()) {
    twins = twinsOfParts(surface, map.partners);
    map.partners.assign(surface.size(), no_index);
    search(close, twins);
  }
  search(NearestPoints(surface, reach), twins);
  search(NearestPoints(surface, reach), {});
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (map.partners[v] != no_index) {
      map.gaps[v] = distance(plane.image(surface.points[v]), surface.points[map.partners[v]]);
    }
  }
  return map;
}

} // namespace symmetry
} // namespace pcl
