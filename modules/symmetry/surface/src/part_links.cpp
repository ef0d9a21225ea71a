#include "symmetry/surface/part_links.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "base/statistics.h"
#include "base/union_find.h"
#include "base/vector_math.h"
#include "cloud/point_grid.h"
#include "symmetry/surface/nearest_of_parts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr float widest_gap = 0.1F;    // of the size of the surface, where points are close: the width of a limb
constexpr float size_of_gap = 0.5F;   // of the smaller side: a head floats over a trunk, two bodies stand side by side
constexpr float sparse_gap = 3.0F;    // spacings of the smaller side: sparse points are no parts of their own
constexpr float near_shortest = 1.5F; // length of a link over that of the shortest between the same parts

constexpr float all_there_is = 64.0F; // surfaces are at unit scale, parts farther away than a few units are dropped

constexpr float nothing = -1.0F; // no distance

constexpr int links_per_point = 8; // to one point, from another part: the way there is known by few

using PartPair = std::pair<Index, Index>;

/** Ways between points of two parts, in the order in which they were found. */
struct PairOfParts {
  PartPair parts;
  std::vector<GraphEdge> ways;
  float gap = 0.0F; ///< length of the shortest
};

using PairedWays = std::vector<std::pair<PartPair, GraphEdge>>;

/** In the order of the parts. */
std::vector<PairOfParts>
sortByParts(PairedWays all)
{
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PairOfParts> pairs;
  for (const auto& [parts, way] : all) {
    heartbeat();
    if (pairs.empty() || pairs.back().parts != parts) {
      pairs.push_back({parts, {}, way.length});
    }
    pairs.back().ways.push_back(way);
    pairs.back().gap = std::min(pairs.back().gap, way.length);
  }
  return pairs;
}

class PartLinker {
public:
  PartLinker(const std::vector<Vector3>& points, const Components& parts, std::vector<float> spacings)
      : points_(points),
        parts_(parts),
        groups_(parts.sizes.size()),
        spacings_(std::move(spacings)),
        nearest_(points, parts.component_of, parts.sizes.size())
  {
    boxes_.resize(parts.sizes.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      boxes_[parts.component_of[v]].extend(points[v]);
    }
  }

  /** Links all parts with points nearer than those of the denser one are apart. */
  void
  linkTouching()
  {
    std::vector<float> reach = spacings_;
    const float typical = typicalSpacing();
    std::transform(reach.begin(), reach.end(), reach.begin(), [typical](float x) { return std::min(x, typical); });
    startRound(typical, reach);
    for (const PairOfParts& pair : waysBetweenParts(reach)) {
      link(pair, typical);
    }
  }

  /** One round of links across narrow gaps: every group to the nearest others. Whether there were any. */
  bool
  linkAcrossNarrowGaps()
  {
    std::vector<float> widest(boxes_.size());
    const float reach = std::max(widest_gap, sparse_gap * typicalSpacing());
    for (std::size_t group = 0; group < widest.size(); ++group) {
      widest[group] = std::min(reach, bridgedBy(static_cast<Index>(group)));
    }
    return linkAcrossGaps(reach, widest, no_index);
  }

  /** The same across gaps however wide, until all is one group. */
  void
  linkAll()
  {
    for (float reach = widest_gap; countGroups() > 1 && reach < all_there_is; reach *= 2.0F) {
      while (linkAcrossGaps(reach, std::vector<float>(boxes_.size(), reach), largestGroup())) {
      }
    }
  }

  LinkedParts
  finish()
  {
    return {std::move(links_), groupNumbers()};
  }

private:
  /** Of ways equally long those to points that come first in a grid count, and only ways to another group.
   * \param[in] farthest of every group: how far others look for it */
  void
  startRound(float cell, const std::vector<float>& farthest)
  {
    nearest_.setOrder(PointGrid(points_, cell).order());
    group_of_ = groupNumbers();
    nearest_.setGroups(group_of_, farthest);
  }

  /** The nearest ways between points of parts that are in different groups: for every point and every other part, by
   * pairs of parts.
   * \param[in] reach of every group: how far its points look around; below 0: not at all, they are met from the other
   * side */
  std::vector<PairOfParts>
  waysBetweenParts(const std::vector<float>& reach)
  {
    PairedWays ways;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      heartbeat();
      const Index part = parts_.component_of[v];
      const Index group = group_of_[part];
      if (reach[group] >= 0.0F) {
        for (const NearestOfParts::Found& found : nearest_.search(points_[v], group, reach[group])) {
          ways.push_back({std::minmax(part, found.part), {static_cast<Index>(v), found.point, found.distance}});
        }
      }
    }
    return sortByParts(std::move(ways));
  }

  /** For every group the distance from the nearest other one that is not too far for either, or below 0.
   * \param[in] widest of every group */
  std::vector<float>
  distancesToOthers(const std::vector<float>& widest)
  {
    std::vector<float> shortest = widest;
    std::vector<char> is_found(widest.size(), 0);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      heartbeat();
      const Index group = group_of_[parts_.component_of[v]];
      for (const NearestOfParts::Found& found : nearest_.search(points_[v], group, shortest[group])) {
        for (const Index either : {group, group_of_[found.part]}) {
          shortest[either] = std::min(shortest[either], found.distance);
          is_found[either] = 1;
        }
      }
    }
    for (std::size_t group = 0; group < shortest.size(); ++group) {
      shortest[group] = is_found[group] != 0 ? shortest[group] : nothing;
    }
    return shortest;
  }

  /** \param[in] widest of every group: the widest gap that it is on either side of, at most \a reach
   * \param[in] passed_over a group that does not look around, or no_index */
  bool
  linkAcrossGaps(float reach, const std::vector<float>& widest, Index passed_over)
  {
    startRound(reach, widest);
    const std::vector<float> shortest = distancesToOthers(widest);
    const float of_passed_over = passed_over == no_index ? nothing : shortest[passed_over];
    std::vector<float> look(widest.size());
    for (std::size_t group = 0; group < look.size(); ++group) {
      // Not the shortest alone: what lies between two others belongs to both.
      look[group] = std::min(widest[group], near_shortest * std::max(shortest[group], of_passed_over));
    }
    if (passed_over != no_index) {
      look[passed_over] = nothing;
    }
    // How far each has to look for all ways across the gaps that will be bridged.
    std::vector<PairOfParts> gaps = waysBetweenParts(look);
    std::fill(look.begin(), look.end(), nothing);
    for (const PairOfParts& pair : gaps) {
      for (const Index part : {pair.parts.first, pair.parts.second}) {
        if (group_of_[part] != passed_over) {
          look[group_of_[part]] = std::max(look[group_of_[part]], near_shortest * pair.gap);
        }
      }
    }
    nearest_.setGroups(group_of_, std::vector<float>(widest.size(), reach));
    for (const PairOfParts& pair : waysBetweenParts(look)) {
      const float longest =
          near_shortest * std::max(shortest[group_of_[pair.parts.first]], shortest[group_of_[pair.parts.second]]);
      const auto [a, b] = pair.parts;
      if (pair.gap <= std::min({widest[group_of_[a]], widest[group_of_[b]], longest})) {
        link(pair, near_shortest * pair.gap);
      }
    }
    return !gaps.empty();
  }

  std::size_t
  countGroups()
  {
    const std::vector<Index> numbers = groupNumbers();
    std::size_t count = 0;
    for (std::size_t part = 0; part < numbers.size(); ++part) {
      count += numbers[part] == static_cast<Index>(part) ? 1U : 0U;
    }
    return count;
  }

  Index
  largestGroup()
  {
    const std::vector<Index> numbers = groupNumbers();
    std::vector<Index> points(numbers.size(), 0);
    for (std::size_t part = 0; part < numbers.size(); ++part) {
      points[numbers[part]] += parts_.sizes[part];
    }
    return static_cast<Index>(std::max_element(points.begin(), points.end()) - points.begin());
  }

  std::vector<Index>
  groupNumbers()
  {
    std::vector<Index> numbers(boxes_.size());
    for (std::size_t part = 0; part < numbers.size(); ++part) {
      numbers[part] = groups_.find(static_cast<Index>(part));
    }
    return numbers;
  }

  /** The widest gap at which a group still belongs to what is beyond. */
  float
  bridgedBy(Index group) const
  {
    const float by_size = std::min(widest_gap, size_of_gap * static_cast<float>(boxes_[group].diagonal()));
    return std::max(by_size, sparse_gap * spacings_[group]);
  }

  float
  typicalSpacing() const
  {
    return median(spacings_);
  }

  void
  link(const PairOfParts& pair, float longest)
  {
    const Index a = groups_.find(pair.parts.first);
    const Index b = groups_.find(pair.parts.second);
    groups_.join(a, b);
    boxes_[std::min(a, b)].extend(boxes_[std::max(a, b)].low);
    boxes_[std::min(a, b)].extend(boxes_[std::max(a, b)].high);
    spacings_[std::min(a, b)] = std::max(spacings_[a], spacings_[b]);
    heartbeat();
    std::map<Index, int> links_to;
    for (const GraphEdge& way : pair.ways) {
      if (way.length <= longest && ++links_to[way.b] <= links_per_point) {
        links_.push_back(way);
      }
    }
  }

  const std::vector<Vector3>& points_;
  const Components& parts_;
  UnionFind groups_;
  std::vector<BoundingBox> boxes_; ///< at the lowest part of each group: of the whole group
  std::vector<float> spacings_;    ///< the same: the widest of its parts
  NearestOfParts nearest_;
  std::vector<Index> group_of_; ///< of every part, as the round began
  std::vector<GraphEdge> links_;
};

} // namespace

LinkedParts
linkParts(const std::vector<Vector3>& points,
          const Components& parts,
          const std::vector<float>& spacings,
          PartGaps gaps)
{
  PartLinker linker(points, parts, spacings);
  linker.linkTouching();
  while (linker.linkAcrossNarrowGaps()) {
  }
  if (gaps == PartGaps::Any) {
    linker.linkAll();
  }
  return linker.finish();
}

} // namespace symmetry
} // namespace pcl
