#include "base/vector_math.h"
#include "symmetry/surface/nearest_of_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>

using namespace pcl::symmetry;

namespace {

/** Points of a lattice, so that many are equally far, in parts at random. */
struct LatticeInParts {
  std::vector<Vector3> points;
  std::vector<Index> part_of;
  std::vector<Index> group_of; ///< two parts each
  std::vector<float> farthest; ///< of every group

  LatticeInParts(std::size_t count, Index parts)
  {
    std::mt19937 random(5);
    const auto coordinate = [&random] {
      return static_cast<float>(random() % 20U);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const float x = coordinate();
      const float y = coordinate();
      points.push_back({x, y, coordinate()});
      part_of.push_back(static_cast<Index>(random() % static_cast<unsigned>(parts)));
    }
    for (Index part = 0; part < parts; ++part) {
      group_of.push_back(part / 2);
      farthest.push_back(part % 3 == 0 ? 2.5F : 100.0F);
    }
  }
};

/** The same by looking at all points in an order. */
std::map<Index, Index>
nearestByPart(const LatticeInParts& lattice, const std::vector<Index>& order, std::size_t from, float reach)
{
  std::map<Index, Index> nearest;
  const auto apart = [&](Index w) {
    return distance(lattice.points[from], lattice.points[w]);
  };
  for (const Index w : order) {
    const Index part = lattice.part_of[w];
    const Index group = lattice.group_of[part];
    if (group == lattice.group_of[lattice.part_of[from]] || apart(w) > std::min(reach, lattice.farthest[group])) {
      continue;
    }
    const auto [known, is_new] = nearest.try_emplace(part, w);
    if (!is_new && apart(w) < apart(known->second)) {
      known->second = w;
    }
  }
  return nearest;
}

/** The nearest few of them, of the lower parts where they are equally far. */
std::map<Index, Index>
nearestOf(const LatticeInParts& lattice, const std::map<Index, Index>& all, std::size_t from, std::size_t count)
{
  std::vector<std::pair<float, Index>> by_distance;
  for (const auto& [part, point] : all) {
    by_distance.emplace_back(distance(lattice.points[from], lattice.points[point]), part);
  }
  std::sort(by_distance.begin(), by_distance.end());
  std::map<Index, Index> few;
  for (std::size_t i = 0; i < count; ++i) {
    few[by_distance[i].second] = all.at(by_distance[i].second);
  }
  return few;
}

/** With parts that have a bit each, and with more. */
class NearestOfPartsTest : public testing::TestWithParam<Index> {};

TEST_P(NearestOfPartsTest, FindsWhatLookingAtAllFinds)
{
  const LatticeInParts lattice(1200, GetParam());
  NearestOfParts nearest(lattice.points, lattice.part_of, lattice.group_of.size());
  std::vector<Index> order(lattice.points.size());
  std::iota(order.rbegin(), order.rend(), 0);
  nearest.setOrder(order);
  nearest.setGroups(lattice.group_of, lattice.farthest);
  for (const float reach : {0.5F, 3.0F, 50.0F}) {
    for (std::size_t v = 0; v < lattice.points.size(); v += 37) {
      std::map<Index, Index> found;
      for (const NearestOfParts::Found& part :
           nearest.search(lattice.points[v], lattice.group_of[lattice.part_of[v]], reach)) {
        EXPECT_EQ(part.distance, distance(lattice.points[v], lattice.points[part.point]));
        found[part.part] = part.point;
      }
      const std::map<Index, Index> all = nearestByPart(lattice, order, v, reach);
      if (all.size() <= NearestOfParts::most_parts) {
        EXPECT_EQ(found, all) << "point " << v << ", reach " << reach;
      }
      else {
        EXPECT_EQ(found, nearestOf(lattice, all, v, NearestOfParts::most_parts)) << "point " << v;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, NearestOfPartsTest, testing::Values(2, 6, 33, 64, 65, 300));

TEST(NearestOfParts, PassesOverNoBoxInWhichAnotherGroupIsToo)
{
  // Along a line, a part after the other, and the middle ones in a group with the first.
  std::vector<Vector3> points;
  std::vector<Index> part_of;
  for (Index i = 0; i < 400; ++i) {
    points.push_back({static_cast<float>(i), 0.0F, 0.0F});
    part_of.push_back(i / 40);
  }
  const std::vector<Index> group_of = {0, 0, 0, 0, 1, 1, 0, 0, 0, 1};
  NearestOfParts nearest(points, part_of, group_of.size());
  nearest.setGroups(group_of, std::vector<float>(group_of.size(), 1e6F));
  for (std::size_t v = 0; v < points.size(); v += 7) {
    std::set<Index> found;
    for (const NearestOfParts::Found& part : nearest.search(points[v], group_of[part_of[v]], 1e6F)) {
      found.insert(part.part);
    }
    const bool is_first = group_of[part_of[v]] == 0;
    EXPECT_EQ(found, is_first ? (std::set<Index>{4, 5, 9}) : (std::set<Index>{0, 1, 2, 3, 6, 7, 8})) << "point " << v;
  }
}

TEST(NearestOfParts, DoesNotLookAtAllPointsThatAreEquallyFar)
{
  std::vector<Vector3> points(20000, {1.0F, 0.0F, 0.0F});
  points.push_back({0.0F, 0.0F, 0.0F});
  std::vector<Index> part_of(points.size(), 0);
  part_of.back() = 1;
  NearestOfParts nearest(points, part_of, 2);
  const auto& found = nearest.search(points.back(), 1, 2.0F);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().distance, 1.0F);
  EXPECT_LT(found.front().looked_at, 2000);
}

TEST(NearestOfParts, OfNothingIsNothing)
{
  const std::vector<Vector3> points;
  const std::vector<Index> part_of;
  NearestOfParts nearest(points, part_of, 0);
  EXPECT_TRUE(nearest.search({0.0F, 0.0F, 0.0F}, 0, 1.0F).empty());
}

} // namespace
