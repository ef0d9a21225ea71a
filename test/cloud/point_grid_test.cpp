#include "cloud/clouds.h"
#include "cloud/point_grid.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<Vector3>
randomPoints(std::size_t n, float low, float high, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Vector3> points(n);
  for (Vector3& p : points) {
    for (float& x : p) {
      x = evenly(random, low, high);
    }
  }
  return points;
}

std::vector<Index>
visited(const PointGrid& grid, const Vector3& place)
{
  std::vector<Index> points;
  grid.visitAround(place, [&](Index i) { points.push_back(i); });
  return points;
}

std::vector<Index>
nearer(const std::vector<Vector3>& points, const Vector3& place, float limit)
{
  std::vector<Index> near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (distance(points[i], place) < limit) {
      near.push_back(static_cast<Index>(i));
    }
  }
  return near;
}

/** Those visited that are near, ascending. */
std::vector<Index>
visitedNearer(const PointGrid& grid, const std::vector<Vector3>& points, const Vector3& place, float limit)
{
  std::vector<Index> near;
  grid.visitAround(place, [&](Index i) {
    if (distance(points[i], place) < limit) {
      near.push_back(i);
    }
  });
  std::sort(near.begin(), near.end());
  return near;
}

TEST(PointGrid, FindsThePointsInABoxOnce)
{
  const std::vector<Vector3> points = randomPoints(1500, -1.0F, 1.0F, 4);
  const PointGrid grid(points, 0.3F);
  const std::vector<Vector3> corners = randomPoints(400, -1.2F, 1.2F, 5);
  std::size_t in_all = 0;
  for (std::size_t c = 0; c < corners.size(); c += 2) {
    Vector3 low;
    Vector3 high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(corners[c][k], corners[c + 1][k]);
      high[k] = std::max(corners[c][k], corners[c + 1][k]);
    }
    const auto is_inside = [&](Index i) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        inside = inside && points[i][k] >= low[k] && points[i][k] <= high[k];
      }
      return inside;
    };
    std::vector<Index> found;
    std::size_t visits = 0;
    grid.visitBox(low, high, [&](Index i) {
      ++visits;
      if (is_inside(i)) {
        found.push_back(i);
      }
    });
    std::vector<Index> inside;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (is_inside(static_cast<Index>(i))) {
        inside.push_back(static_cast<Index>(i));
      }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, inside);
    in_all += found.size();
  }
  EXPECT_GT(in_all, 1000U);
}

TEST(PointGrid, VisitsFewPointsAroundASmallBox)
{
  const std::vector<Vector3> points = randomPoints(4000, -1.0F, 1.0F, 6);
  const PointGrid grid(points, 0.2F);
  std::size_t around = 0;
  std::size_t box = 0;
  for (const Vector3& place : randomPoints(100, -1.0F, 1.0F, 7)) {
    grid.visitAround(place, [&](Index) { ++around; });
    const Vector3 reach{0.05F, 0.05F, 0.05F};
    grid.visitBox(place - reach, place + reach, [&](Index) { ++box; });
  }
  EXPECT_GT(box, 0U);
  EXPECT_LT(4 * box, around);
}

TEST(PointGrid, FindsThePointsNearerThanAnEdgeOnce)
{
  const std::vector<Vector3> points = randomPoints(1500, -1.0F, 1.0F, 1);
  const std::vector<Vector3> places = randomPoints(300, -1.3F, 1.3F, 2); // some of them outside
  std::size_t found = 0;
  for (const float cell : {0.07F, 0.3F, 5.0F}) {
    const PointGrid grid(points, cell);
    for (const Vector3& place : places) {
      const std::vector<Index> near = nearer(points, place, cell);
      ASSERT_EQ(visitedNearer(grid, points, place, cell), near);
      found += near.size();
    }
  }
  EXPECT_GT(found, points.size());
}

TEST(PointGrid, VisitsTheCubesAroundAndNoOthers)
{
  // One point in the middle of every cube, on both sides of zero.
  constexpr float cell = 0.25F;
  std::vector<Vector3> points;
  for (int z = -4; z < 4; ++z) {
    for (int y = -4; y < 4; ++y) {
      for (int x = -4; x < 4; ++x) {
        const Vector3 corner{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        points.push_back(cell * (corner + Vector3{0.5F, 0.5F, 0.5F}));
      }
    }
  }
  const PointGrid grid(points, cell);
  std::size_t inside = 0;
  for (const Vector3& place : points) {
    std::vector<Index> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3 offset = points[i] - place;
      if (std::abs(offset[0]) < 1.5F * cell && std::abs(offset[1]) < 1.5F * cell && std::abs(offset[2]) < 1.5F * cell) {
        expected.push_back(static_cast<Index>(i));
      }
    }
    std::vector<Index> found = visited(grid, place);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
    inside += found.size() == 27 ? 1U : 0U;
  }
  EXPECT_EQ(inside, 216U); // the cubes within
}

TEST(PointGrid, FindsPointsOnTheSidesOfCubesAcrossZero)
{
  constexpr float cell = 0.5F;
  const std::vector<Vector3> points{{-0.49F, 0.0F, 0.0F}, {0.0F, -0.49F, 0.0F}, {0.0F, 0.0F, -0.49F},
                                    {-0.0F, 0.0F, -0.0F}, {0.49F, 0.0F, 0.0F},  {-0.28F, -0.28F, -0.28F}};
  const PointGrid grid(points, cell);
  EXPECT_EQ(visitedNearer(grid, points, {0.0F, 0.0F, 0.0F}, cell), (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(visitedNearer(grid, points, {-0.0F, -0.0F, -0.0F}, cell), (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(visitedNearer(grid, points, {-0.5F, 0.0F, 0.0F}, cell), (std::vector<Index>{0, 5}));
}

TEST(PointGrid, OrderIsFixedAndAscendingWithinACube)
{
  const std::vector<Vector3> points = randomPoints(500, -1.0F, 1.0F, 3);
  const Vector3 place{-0.1F, 0.2F, 0.0F};
  EXPECT_EQ(visited(PointGrid(points, 0.4F), place), visited(PointGrid(points, 0.4F), place));

  const std::vector<Vector3> close = randomPoints(500, 0.1F, 0.2F, 4);
  std::vector<Index> all(close.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(visited(PointGrid(close, 1.0F), place), all);
}

TEST(PointGrid, ManagesTheSmallestCells)
{
  constexpr float cell = 1.2e-6F;
  std::vector<Vector3> points{{-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}, {0.0F, 0.0F, 0.0F}};
  for (std::size_t i = 0; i < 3; ++i) {
    points.push_back(points[i] + Vector3{0.0F, 6e-7F, 0.0F});
  }
  const PointGrid grid(points, cell);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(visitedNearer(grid, points, points[i], cell), nearer(points, points[i], cell));
    EXPECT_EQ(visited(grid, points[i]).size(), 2U);
  }
}

TEST(PointGrid, TakesLargerCubesThanItCannotNumber)
{
  const std::vector<Vector3> points{{-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {0.0F, 0.0F, 0.0F}};
  for (const float cell : {1e-9F, 1e-30F, 0.0F}) {
    const PointGrid grid(points, cell);
    EXPECT_EQ(visited(grid, points[0]), (std::vector<Index>{0}));
    EXPECT_EQ(visited(grid, points[1]), (std::vector<Index>{1, 2}));
    EXPECT_EQ(visited(grid, points[3]), (std::vector<Index>{3}));
  }
}

TEST(PointGrid, VisitsNothingWhereThereIsNothing)
{
  EXPECT_TRUE(visited(PointGrid({}, 0.1F), {0.0F, 0.0F, 0.0F}).empty());
  EXPECT_TRUE(visited(PointGrid({{0.5F, 0.5F, 0.5F}}, 0.1F), {-0.5F, 0.5F, 0.5F}).empty());
}

TEST(PointGrid, TheNearestPointIsMetBeforeVisitsEnd)
{
  const std::vector<Vector3> points = randomPoints(2000, -1.0F, 1.0F, 9);
  const PointGrid grid(points, 0.04F);
  for (const Vector3& place : randomPoints(300, -1.3F, 1.3F, 10)) {
    for (const float reach : {0.01F, 0.2F, 5.0F}) {
      Index nearest = no_index;
      float least = reach;
      std::size_t count = 0;
      grid.visitNearest(place, reach, [&](Index i) {
        ++count;
        if (distance(points[i], place) < least) {
          least = distance(points[i], place);
          nearest = i;
        }
        return least;
      });
      const std::vector<Index> all = nearer(points, place, reach);
      const auto closest = std::min_element(all.begin(), all.end(), [&](Index a, Index b) {
        return distance(points[a], place) < distance(points[b], place);
      });
      EXPECT_EQ(nearest, closest == all.end() ? no_index : *closest);
      EXPECT_LT(count, 1000U);
    }
  }
}

TEST(PointGrid, VisitsOfTheNearestMeetEachPointOnce)
{
  const std::vector<Vector3> points = randomPoints(500, -1.0F, 1.0F, 9);
  std::vector<int> visits(points.size(), 0);
  PointGrid(points, 0.3F).visitNearest({0.1F, 0.2F, 0.3F}, 4.0F, [&](Index i) {
    ++visits[i];
    return 4.0F;
  });
  EXPECT_EQ(visits, std::vector<int>(points.size(), 1));
}

double
meanVisited(const std::vector<Vector3>& points, float cell)
{
  const PointGrid grid(points, cell);
  std::size_t count = 0;
  for (const Vector3& p : points) {
    count += visited(grid, p).size();
  }
  return static_cast<double>(count) / static_cast<double>(points.size());
}

TEST(UncrowdedCell, IsTheGivenOneWhereThereIsRoom)
{
  EXPECT_EQ(uncrowdedCell(randomPoints(3000, -1.0F, 1.0F, 3), 0.1F, 100), 0.1F);
}

TEST(UncrowdedCell, IsAsLargeAsTheCrowdAllows)
{
  const std::vector<Vector3> points = randomPoints(3000, -1.0F, 1.0F, 3);
  ASSERT_GT(meanVisited(points, 0.8F), 100.0);
  const float cell = uncrowdedCell(points, 0.8F, 100);
  EXPECT_LE(meanVisited(points, cell), 100.0);
  EXPECT_GT(meanVisited(points, 1.3F * cell), 100.0);
}

TEST(UncrowdedCell, IsNotSearchedForEverWhereAllPointsAreOne)
{
  EXPECT_GT(uncrowdedCell(std::vector<Vector3>(500), 1.0F, 100), 0.005F);
}

} // namespace
