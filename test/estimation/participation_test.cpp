// Which points take part in an estimation by the class, and what is said of those that do not.
#include "estimation/class_runs.h"
#include "estimation/left_out_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** No number of the result refers to a point that is marked. */
void
expectNoReferenceTo(const SymmetryResult& result, const std::vector<char>& marked)
{
  const auto is_marked = [&](Index v) {
    return v != no_index && marked[v] != 0;
  };
  EXPECT_TRUE(std::none_of(result.partners.begin(), result.partners.end(), is_marked));
  EXPECT_TRUE(std::none_of(result.extremities.begin(), result.extremities.end(), is_marked));
  for (const SymmetricMatch& match : result.matches) {
    EXPECT_FALSE(is_marked(match.source) || is_marked(match.target) || is_marked(match.midpoint));
  }
  for (const Polyline& line : result.axis) {
    EXPECT_TRUE(std::none_of(line.points.begin(), line.points.end(), is_marked));
    EXPECT_TRUE(std::none_of(line.curve.begin(), line.curve.end(),
                             [&](const AxisPoint& place) { return is_marked(place.nearest); }));
  }
}

TEST(Participation, NonFinitePointsTakeNoPart)
{
  // Unused points among the others: the mesh stays as it is, but for the numbers.
  Surface surface;
  std::vector<char> marked;
  std::vector<Index> new_number;
  for (const Vector3& p : bentHuman().surface.points) {
    if (surface.size() % 100 == 7) {
      surface.points.push_back({p[0], surface.size() % 200 == 7 ? not_a_number : INFINITY, p[2]});
      marked.push_back(1);
    }
    new_number.push_back(static_cast<Index>(surface.size()));
    surface.points.push_back(p);
    marked.push_back(0);
  }
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({new_number[t[0]], new_number[t[1]], new_number[t[2]]});
  }
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface));
  const SymmetryResult expected = estimateIntrinsicSymmetry(bentHuman().surface, staged());
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  ASSERT_EQ(result.partners.size(), surface.size());
  for (std::size_t v = 0; v < new_number.size(); ++v) {
    EXPECT_EQ(result.partners[new_number[v]], new_number[expected.partners[v]]);
  }
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (marked[v] != 0) {
      expectNothingAbout(result, v);
    }
  }
  expectNoReferenceTo(result, marked);
  EXPECT_EQ(result.input.non_finite, surface.size() - new_number.size());
  EXPECT_EQ(result.input.used, new_number.size());
}

TEST(Participation, PointsOutsideTheIndicesTakeNoPart)
{
  // Two bodies side by side, of which the indices choose the second; its points come in falling order.
  Surface surface = bentHuman().surface;
  const auto n = static_cast<Index>(surface.size());
  for (const Vector3& p : bentHuman().surface.points) {
    surface.points.push_back(p + Vector3{10.0F, 0.0F, 0.0F});
  }
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (Index v = 2 * n; v-- > n;) {
    indices->push_back(v);
  }
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface), indices);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  ASSERT_EQ(result.partners.size(), surface.size());
  std::vector<char> marked(surface.size(), 0);
  for (Index v = 0; v < n; ++v) {
    marked[v] = 1;
    expectNothingAbout(result, static_cast<std::size_t>(v));
  }
  expectNoReferenceTo(result, marked);
  const std::vector<Index> partners(result.partners.begin() + n, result.partners.end());
  std::vector<Index> of_one_body;
  for (const Index partner : partners) {
    of_one_body.push_back(partner - n);
  }
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), of_one_body)), 0.95);
  EXPECT_EQ(result.input.points, surface.size());
  EXPECT_EQ(result.input.outside_indices, static_cast<std::size_t>(n));
  EXPECT_EQ(result.input.used, static_cast<std::size_t>(n));
}

TEST(Participation, OnlyTheLargestObjectTakesPart)
{
  Surface surface = scaled(sphereMesh(3), {0.1F, 0.1F, 0.1F});
  for (Vector3& p : surface.points) {
    p[0] += 5.0F; // farther away than either is large
  }
  const auto sphere = static_cast<Index>(surface.size());
  surface.points.insert(surface.points.end(), bentHuman().surface.points.begin(), bentHuman().surface.points.end());
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({t[0] + sphere, t[1] + sphere, t[2] + sphere});
  }
  surface.points.push_back({50.0F, 0.0F, 0.0F}); // on no face
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface));
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  std::vector<char> marked(surface.size(), 0);
  std::fill_n(marked.begin(), sphere, char{1});
  marked.back() = 1;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (marked[v] != 0) {
      expectNothingAbout(result, v);
    }
    else {
      EXPECT_NE(result.partners[v], no_index);
    }
  }
  expectNoReferenceTo(result, marked);
  EXPECT_EQ(result.input.components, 2U);
  EXPECT_EQ(result.input.unused, 1U);
  EXPECT_EQ(result.input.linked_parts, 0U);
  EXPECT_EQ(result.input.other_components, static_cast<std::size_t>(sphere));
  EXPECT_EQ(result.input.used, bentHuman().surface.size());
}

} // namespace
