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

constexpr int links_per_point = 8; // to one point, from another part: the way there is known by few

using PartPair = std::pair<Index, Index>;

float
shortestOf(const std::vector<GraphEdge>& ways)
{
  float shortest = std::numeric_limits<float>::infinity();
  for (const GraphEdge& way : ways) {
    shortest = std::min(shortest, way.length);
  }
  return shortest;
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
    for (const auto& [pair, ways] : waysBetweenParts(groupNumbers(), typicalSpacing())) {
      const float spacing = std::min(spacings_[pair.first], spacings_[pair.second]);
      if (shortestOf(ways) <= spacing) {
        link(pair, ways, spacing);
      }
    }
  }

  /** One round of links across narrow gaps: every group to the nearest others. Whether there were any. */
  bool
  linkAcrossNarrowGaps()
  {
    return linkAcrossGaps(std::max(widest_gap, sparse_gap * typicalSpacing()), no_index,
                          [this](Index a, Index b) { return std::min(bridgedBy(a), bridgedBy(b)); });
  }

  /** The same across gaps however wide, until all is one group. */
  void
  linkAll()
  {
    for (float reach = widest_gap; countGroups() > 1 && reach < all_there_is; reach *= 2.0F) {
      while (linkAcrossGaps(reach, largestGroup(), [reach](Index, Index) { return reach; })) {
      }
    }
  }

  LinkedParts
  finish()
  {
    return {std::move(links_), groupNumbers()};
  }

private:
  /** The nearest ways between points of parts that are in different groups, within a distance: for every point and
   * every other part, by pairs of parts. Points of one group are passed over: they are met from the other side. */
  std::map<PartPair, std::vector<GraphEdge>>
  waysBetweenParts(const std::vector<Index>& group_of, float reach, Index passed_over = no_index)
  {
    nearest_.setOrder(PointGrid(points_, reach).order());
    std::map<PartPair, std::vector<GraphEdge>> ways;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      heartbeat();
      const Index part = parts_.component_of[v];
      const Index group = group_of[part];
      if (group == passed_over) {
        continue;
      }
      for (const NearestOfParts::Found& found : nearest_.search(points_[v], group_of, group, reach)) {
        ways[std::minmax(part, found.part)].push_back({static_cast<Index>(v), found.point, found.distance});
      }
    }
    return ways;
  }

  /** \param[in] widest called with two groups: the widest gap between them that is bridged */
  template <typename Widest>
  bool
  linkAcrossGaps(float reach, Index passed_over, Widest widest)
  {
    const std::vector<Index> before = groupNumbers();
    const auto all_ways = waysBetweenParts(before, reach, passed_over);
    std::vector<float> shortest(before.size(), std::numeric_limits<float>::infinity()); // per group
    std::vector<std::pair<PartPair, float>> gaps;
    for (const auto& [pair, ways] : all_ways) {
      const float gap = shortestOf(ways);
      if (gap <= widest(before[pair.first], before[pair.second])) {
        gaps.push_back({pair, gap});
        for (const Index part : {pair.first, pair.second}) {
          shortest[before[part]] = std::min(shortest[before[part]], gap);
        }
      }
    }
    for (const auto& [pair, gap] : gaps) {
      // Not the shortest alone: what lies between two others belongs to both.
      if (gap <= near_shortest * std::max(shortest[before[pair.first]], shortest[before[pair.second]])) {
        link(pair, all_ways.at(pair), near_shortest * gap);
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
  link(const PartPair& pair, const std::vector<GraphEdge>& ways, float longest)
  {
    const Index a = groups_.find(pair.first);
    const Index b = groups_.find(pair.second);
    groups_.join(a, b);
    boxes_[std::min(a, b)].extend(boxes_[std::max(a, b)].low);
    boxes_[std::min(a, b)].extend(boxes_[std::max(a, b)].high);
    spacings_[std::min(a, b)] = std::max(spacings_[a], spacings_[b]);
    std::map<Index, int> links_to;
    for (const GraphEdge& way : ways) {
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
