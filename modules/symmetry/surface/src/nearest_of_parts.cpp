#include "symmetry/surface/nearest_of_parts.h"

#include "base/median_split.h"
#include "base/vector_math.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t most_bits = 64;

/** Points of a part that are looked at before any will do: some tens are enough, unless the part is so small and so far
 * that its points are all equally far but for rounding. */
constexpr int most_looked_at = 1000;

} // namespace

NearestOfParts::NearestOfParts(const std::vector<Vector3>& points, const std::vector<Index>& part_of, std::size_t parts)
    : points_(points),
      part_of_(part_of),
      group_of_(parts),
      farthest_(parts, std::numeric_limits<float>::infinity()),
      ranks_(points.size()),
      entries_(points.size()),
      nodes_(1),
      place_in_found_(parts, no_index)
{
  std::iota(ranks_.begin(), ranks_.end(), 0);
  std::iota(entries_.begin(), entries_.end(), 0);
  nodes_.front().end = static_cast<std::uint32_t>(points.size());
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    build(node);
  }
  std::iota(group_of_.begin(), group_of_.end(), 0);
  setGroups(group_of_, farthest_);
}

void
NearestOfParts::setOrder(const std::vector<Index>& order)
{
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    ranks_[order[rank]] = static_cast<Index>(rank);
  }
}

void
NearestOfParts::setGroups(const std::vector<Index>& group_of, const std::vector<float>& farthest)
{
  group_of_ = group_of;
  farthest_ = farthest;
  std::for_each(nodes_.rbegin(), nodes_.rend(), [this](Node& node) { setGroup(node); }); // children come later
}

void
NearestOfParts::setGroup(Node& node) const
{
  node.only_group = no_index;
  node.farthest = 0.0F;
  if (node.children != 0) {
    const Node& first = nodes_[node.children];
    const Node& second = nodes_[node.children + 1];
    node.only_group = first.only_group == second.only_group ? first.only_group : no_index;
    node.farthest = std::max(first.farthest, second.farthest);
    return;
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const Index group = group_of_[part_of_[entries_[i]]];
    node.only_group = i == node.begin || group == node.only_group ? group : no_index;
    node.farthest = std::max(node.farthest, farthest_[group]);
  }
}

/** Fills in a node of which only the entries are known, and splits it at the middle of its longest side. */
void
NearestOfParts::build(std::size_t node)
{
  constexpr std::uint32_t most_entries = 8;
  const auto [begin, end] = std::pair(nodes_[node].begin, nodes_[node].end);
  BoundingBox box;
  std::uint64_t parts = 0;
  Index only_part = no_index;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.extend(points_[entries_[i]]);
    const Index part = part_of_[entries_[i]];
    parts |= std::uint64_t{1} << (static_cast<std::size_t>(part) % most_bits);
    only_part = i == begin || part == only_part ? part : no_index;
  }
  nodes_[node].box = box;
  nodes_[node].parts = parts;
  nodes_[node].only_part = only_part;
  if (end - begin <= most_entries) {
    return;
  }
  const std::uint32_t middle = splitAtMedian(points_, box, begin, end, entries_);
  nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().begin = begin;
  nodes_.back().end = middle;
  nodes_.emplace_back();
  nodes_.back().begin = middle;
  nodes_.back().end = end;
}

const std::vector<NearestOfParts::Found>&
NearestOfParts::search(const Vector3& place, Index group, float reach)
{
  for (const Found& old : found_) {
    place_in_found_[old.part] = no_index;
  }
  found_.clear();
  Query query{place, group, reach};
  if (isOfUse(nodes_.front(), query)) {
    visit(nodes_.front(), query);
  }
  keepNearest(query);
  return found_;
}

/** Whether a part may have a point that is nearer than what is known. */
bool
NearestOfParts::isOfUse(Index part, double nearest, const Query& query) const
{
  const Index known = place_in_found_[part];
  const Index group = group_of_[part];
  return group != query.group && nearest <= double{farthest_[group]} &&
         (known == no_index || (found_[known].distance >= nearest && found_[known].looked_at < most_looked_at));
}

/** The same for a box. */
bool
NearestOfParts::isOfUse(const Node& node, const Query& query) const
{
  constexpr double rounding = 0.99999; // of floats, a hundred times over: nothing is left out for it
  const double nearest = rounding * node.box.straightDistanceTo(query.place);
  if (nearest > double{std::min(query.reach, node.farthest)} || node.only_group == query.group) {
    return false;
  }
  if (node.only_part != no_index) {
    return isOfUse(node.only_part, nearest, query);
  }
  const std::size_t parts = place_in_found_.size();
  if (parts > most_bits) {
    return true;
  }
  for (std::size_t part = 0; part < parts; ++part) {
    if ((node.parts >> part & 1U) != 0 && isOfUse(static_cast<Index>(part), nearest, query)) {
      return true;
    }
  }
  return false;
}

void
NearestOfParts::visit(const Node& node, Query& query)
{
  if (node.children == 0) {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      offer(entries_[i], query);
    }
    return;
  }
  const Node* near = &nodes_[node.children];
  const Node* far = &nodes_[node.children + 1];
  if (far->box.straightDistanceTo(query.place) < near->box.straightDistanceTo(query.place)) {
    std::swap(near, far);
  }
  for (const Node* child : {near, far}) {
    if (isOfUse(*child, query)) {
      visit(*child, query);
    }
  }
}

void
NearestOfParts::offer(Index point, Query& query)
{
  const Index part = part_of_[point];
  const Index group = group_of_[part];
  if (group == query.group) {
    return;
  }
  const float apart = distance(query.place, points_[point]);
  if (apart > query.reach || apart > farthest_[group]) {
    return;
  }
  Index& known = place_in_found_[part];
  if (known == no_index) {
    known = static_cast<Index>(found_.size());
    found_.push_back({part, point, apart, 1});
    if (found_.size() >= 2 * most_parts) {
      keepNearest(query);
    }
    return;
  }
  Found& best = found_[known];
  ++best.looked_at;
  if (apart < best.distance || (apart == best.distance && ranks_[point] < ranks_[best.point])) {
    best.point = point;
    best.distance = apart;
  }
}

/** Forgets all but the nearest parts. */
void
NearestOfParts::keepNearest(Query& query)
{
  if (found_.size() <= most_parts) {
    return;
  }
  const auto first_left_out = found_.begin() + static_cast<std::ptrdiff_t>(most_parts);
  std::nth_element(found_.begin(), first_left_out - 1, found_.end(), [](const Found& a, const Found& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.part < b.part);
  });
  std::for_each(first_left_out, found_.end(), [this](const Found& found) { place_in_found_[found.part] = no_index; });
  found_.erase(first_left_out, found_.end());
  for (std::size_t i = 0; i < found_.size(); ++i) {
    place_in_found_[found_[i].part] = static_cast<Index>(i);
  }
  query.reach = found_.back().distance;
}

} // namespace symmetry
} // namespace pcl
