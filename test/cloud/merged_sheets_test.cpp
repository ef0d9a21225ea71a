#include "cloud/clouds.h"
#include "cloud/merged_sheets.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float half_edge = 0.3F;
constexpr float spacing = 0.02F;

/** A square of discs across one axis, with normals of either sign. */
void
appendSquare(std::vector<Surfel>& surfels, std::size_t axis, float at)
{
  for (float u = -half_edge; u <= half_edge; u += spacing) {
    for (float v = -half_edge; v <= half_edge; v += spacing) {
      Surfel surfel;
      surfel.centre[axis] = at;
      surfel.centre[(axis + 1) % 3] = u;
      surfel.centre[(axis + 2) % 3] = v;
      surfel.normal[axis] = surfels.size() % 2 == 0 ? 1.0F : -1.0F;
      surfel.radius = spacing;
      surfels.push_back(surfel);
    }
  }
}

/** Two boxes, one on the other: a cube with a wall across the middle. */
std::vector<Surfel>
boxesInContact()
{
  std::vector<Surfel> surfels;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    appendSquare(surfels, axis, -half_edge);
    appendSquare(surfels, axis, half_edge);
  }
  appendSquare(surfels, 2, 0.0F);
  return surfels;
}

LayerSides
sidesOf(const std::vector<Surfel>& surfels)
{
  std::vector<Vector3> places;
  std::vector<Vector3> normals;
  for (const Surfel& surfel : surfels) {
    places.push_back(surfel.centre);
    normals.push_back(surfel.normal);
  }
  return lookToBothSides(surfels, places, normals, spacing);
}

TEST(MergedSheets, AreLayersWithoutAnOutside)
{
  const std::vector<Surfel> surfels = boxesInContact();
  const LayerSides layers = sidesOf(surfels);
  ASSERT_EQ(layers.sides.size(), surfels.size());
  constexpr float from_edges = half_edge - 0.08F;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const Vector3& p = surfels[i].centre;
    const bool is_wall = p[2] == 0.0F && std::abs(p[0]) < from_edges && std::abs(p[1]) < from_edges;
    const bool is_top = p[2] == half_edge && std::abs(p[0]) < from_edges && std::abs(p[1]) < from_edges;
    if (is_wall) {
      ASSERT_EQ(layers.sides[i], Sides::Inside);
    }
    if (is_top) {
      ASSERT_EQ(layers.sides[i], Sides::Outside);
      ASSERT_EQ(layers.normals[i], (Vector3{0.0F, 0.0F, 1.0F}));
    }
  }
}

TEST(MergedSheets, AreNotTold_WhereNothingIsEnclosed)
{
  std::vector<Surfel> sheet;
  appendSquare(sheet, 0, 0.0F);
  EXPECT_TRUE(sidesOf(sheet).sides.empty());
}

TEST(MergedSheets, AreNotToldWithoutASpacing)
{
  const std::vector<Surfel> surfels(50, Surfel{{0.1F, 0.2F, 0.3F}, {0.0F, 0.0F, 1.0F}, 0.0F});
  const std::vector<Vector3> places(50, Vector3{0.1F, 0.2F, 0.3F});
  const std::vector<Vector3> normals(50, Vector3{0.0F, 0.0F, 1.0F});
  EXPECT_TRUE(lookToBothSides(surfels, places, normals, 0.0F).sides.empty());
}

TEST(NeighboursOnOwnSheet, LeaveOutOpposedNormals)
{
  const std::vector<Vector3> normals{
      {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, 0.6F, 0.8F}};
  NeighbourLists lists;
  lists.k = 4;
  lists.neighbours = {1, 2, 3, 4, 0, 3, 2, 4, 0, 1, 3, 4, 0, 1, 2, 4, 0, 1, 2, no_index};
  const NeighbourLists own = neighboursOnOwnSheet(lists, normals, 2);
  EXPECT_EQ(own.k, 2U);
  EXPECT_EQ(own.neighbours, (std::vector<Index>{2, 3, 2, no_index, 0, 1, 0, 2, 0, 2}));
}

} // namespace
