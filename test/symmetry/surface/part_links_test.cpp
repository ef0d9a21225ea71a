#include "base/vector_math.h"
#include "support/graphs.h"
#include "support/shapes.h"
#include "symmetry/surface/part_links.h"

#include <gtest/gtest.h>

#include <algorithm>

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

} // namespace
