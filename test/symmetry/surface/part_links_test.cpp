#include "base/bounding_box.h"
#include "base/union_find.h"
#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "support/graphs.h"
#include "support/shapes.h"
#include "symmetry/surface/part_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Spheres of a radius around places, with sides of about an eighth of it. */
Surface
spheresAt(const std::vector<Vector3>& places, float radius)
{
  Surface all;
  for (const Vector3& place : places) {
    const Surface sphere = scaled(sphereMesh(3), {radius, radius, radius});
    const auto first = static_cast<Index>(all.size());
    for (const Vector3& p : sphere.points) {
      all.points.push_back(place + p);
    }
    for (const Triangle& t : sphere.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return all;
}

LinkedParts
linked(const Surface& mesh, PartGaps gaps = PartGaps::Narrow)
{
  const Components parts = connectedComponents(meshGraph(mesh));
  return linkParts(mesh.points, parts, std::vector<float>(parts.sizes.size(), 0.02F), gaps);
}

std::size_t
countGroups(const LinkedParts& parts)
{
  std::vector<Index> groups = parts.group_of;
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups.size();
}

TEST(PartLinks, JoinsPartsThatOverlapWhereTheyMeet)
{
  const Surface mesh = spheresAt({{0, 0, 0}, {0.15F, 0, 0}}, 0.1F);
  const LinkedParts parts = linked(mesh);
  EXPECT_EQ(countGroups(parts), 1U);
  ASSERT_FALSE(parts.links.empty());
  for (const GraphEdge& link : parts.links) {
    EXPECT_LE(link.length, 0.02F);
    EXPECT_FLOAT_EQ(link.length, distance(mesh.points[link.a], mesh.points[link.b]));
    EXPECT_NEAR(mesh.points[link.a][0], 0.075F, 0.03F); // the circle in which the spheres meet
  }
}

TEST(PartLinks, BridgesAGapThatIsNarrowNextToTheParts)
{
  EXPECT_EQ(countGroups(linked(spheresAt({{0, 0, 0}, {0.25F, 0, 0}}, 0.1F))), 1U);
}

TEST(PartLinks, LeavesApartWhatIsFartherAwayThanItIsLarge)
{
  const Surface mesh = spheresAt({{0, 0, 0}, {0.09F, 0, 0}}, 0.01F); // a gap of 0.07 between parts of 0.02
  EXPECT_EQ(countGroups(linked(mesh)), 2U);
  EXPECT_TRUE(linked(mesh).links.empty());
  EXPECT_EQ(countGroups(linked(mesh, PartGaps::Any)), 1U);
}

TEST(PartLinks, LinksWhatLiesBetweenTwoOthersToBoth)
{
  const LinkedParts parts = linked(spheresAt({{-0.25F, 0, 0}, {0, 0, 0}, {0.26F, 0, 0}}, 0.1F));
  EXPECT_EQ(countGroups(parts), 1U);
  const auto leads_left =
      std::count_if(parts.links.begin(), parts.links.end(), [](const GraphEdge& link) { return link.length < 0.08F; });
  EXPECT_GT(leads_left, 0);
  EXPECT_LT(leads_left, static_cast<std::ptrdiff_t>(parts.links.size()));
}

TEST(PartLinks, BridgesAnyGapInTheEnd)
{
  const Surface mesh = spheresAt({{0, 0, 0}, {0.9F, 0, 0}, {0, 2.5F, 0}, {0.12F, 2.5F, 0}}, 0.02F);
  EXPECT_EQ(countGroups(linked(mesh)), 4U);
  EXPECT_EQ(countGroups(linked(mesh, PartGaps::Any)), 1U);
}

TEST(PartLinks, OnePartNeedsNone)
{
  const LinkedParts parts = linked(spheresAt({{0, 0, 0}}, 0.1F));
  EXPECT_TRUE(parts.links.empty());
  EXPECT_EQ(parts.group_of, std::vector<Index>{0});
}

/** Small clouds in random places, some of them larger. */
struct RandomParts {
  std::vector<Vector3> points;
  Components parts;

  RandomParts(unsigned seed, Index count)
  {
    std::mt19937 random(seed);
    for (Index part = 0; part < count; ++part) {
      const Vector3 middle{evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F), evenly(random, -0.5F, 0.5F)};
      const float size = evenly(random, 0.02F, 0.4F);
      const auto number = static_cast<Index>(10 + random() % 40U);
      for (Index i = 0; i < number; ++i) {
        points.push_back(middle + Vector3{evenly(random, 0.0F, size), evenly(random, 0.0F, size), 0.0F});
        parts.component_of.push_back(part);
      }
      parts.sizes.push_back(number);
    }
  }
};

/** What is linked across narrow gaps, by looking at all pairs of points. */
class LinksByHand {
public:
  LinksByHand(const RandomParts& all, float spacing)
      : count_(all.parts.sizes.size()), gap_(count_ * count_, 1e9F), boxes_(count_), groups_(count_)
  {
    for (std::size_t v = 0; v < all.points.size(); ++v) {
      boxes_[all.parts.component_of[v]].extend(all.points[v]);
      for (std::size_t w = 0; w < all.points.size(); ++w) {
        float& gap = gap_[count_ * all.parts.component_of[v] + all.parts.component_of[w]];
        gap = std::min(gap, distance(all.points[v], all.points[w]));
      }
    }
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = a + 1; b < count_; ++b) {
        if (gap_[count_ * a + b] <= spacing) {
          linked.insert({a, b});
        }
      }
    }
    joinLinked();
    while (linkOnce(spacing)) {
    }
  }

  std::set<std::pair<std::size_t, std::size_t>> linked;

private:
  void
  joinLinked()
  {
    for (const auto& [a, b] : linked) {
      groups_.join(static_cast<Index>(a), static_cast<Index>(b));
    }
  }

  float
  widest(Index group, float spacing)
  {
    BoundingBox box;
    for (std::size_t part = 0; part < count_; ++part) {
      if (groups_.find(static_cast<Index>(part)) == group) {
        box.extend(boxes_[part].low);
        box.extend(boxes_[part].high);
      }
    }
    return std::max(std::min(0.1F, 0.5F * static_cast<float>(box.diagonal())), 3.0F * spacing);
  }

  bool
  linkOnce(float spacing)
  {
    std::vector<float> shortest(count_, 1e9F);
    std::vector<std::pair<std::size_t, std::size_t>> narrow;
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = a + 1; b < count_; ++b) {
        const Index of_a = groups_.find(static_cast<Index>(a));
        const Index of_b = groups_.find(static_cast<Index>(b));
        const float gap = gap_[count_ * a + b];
        if (of_a != of_b && gap <= std::min(widest(of_a, spacing), widest(of_b, spacing))) {
          narrow.emplace_back(a, b);
          shortest[of_a] = std::min(shortest[of_a], gap);
          shortest[of_b] = std::min(shortest[of_b], gap);
        }
      }
    }
    for (const auto& [a, b] : narrow) {
      const float least =
          std::max(shortest[groups_.find(static_cast<Index>(a))], shortest[groups_.find(static_cast<Index>(b))]);
      if (gap_[count_ * a + b] <= 1.5F * least) {
        linked.insert({a, b});
      }
    }
    joinLinked();
    return !narrow.empty();
  }

  std::size_t count_;
  std::vector<float> gap_;
  std::vector<BoundingBox> boxes_;
  UnionFind groups_;
};

TEST(PartLinks, AreThoseThatLookingAtAllPairsOfPointsGives)
{
  constexpr float spacing = 0.01F;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const RandomParts all(seed, static_cast<Index>(3 + seed));
    const LinkedParts found =
        linkParts(all.points, all.parts, std::vector<float>(all.parts.sizes.size(), spacing), PartGaps::Narrow);
    std::set<std::pair<std::size_t, std::size_t>> linked;
    for (const GraphEdge& link : found.links) {
      linked.insert(std::minmax<std::size_t>(all.parts.component_of[link.a], all.parts.component_of[link.b]));
    }
    EXPECT_EQ(linked, LinksByHand(all, spacing).linked) << "seed " << seed;
  }
}

} // namespace
