#include "support/human.h"
#include "support/sample_partners.h"
#include "symmetry/sides/sample_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::vector<float>
sidesUnder(const CoarseBody& body, const std::vector<Index>& partners)
{
  return sampleSides(body.sampled(), partners);
}

/** Share of the samples of the human off the axis that are on the same side as the true ones, or all on the other. */
double
rightShare(const std::vector<float>& sides)
{
  double right = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const int side = trueSide(static_cast<Index>(i));
    all += side != 0 ? 1.0 : 0.0;
    right += static_cast<float>(side) * sides[i] > 0.0F ? 1.0 : 0.0;
  }
  return std::max(right, all - right) / all;
}

TEST(SampleSides, AreRightUnderTheTrueMap)
{
  const std::vector<float> sides = sidesUnder(human(), truePartners(human()));
  ASSERT_EQ(sides.size(), human().coarse.size());
  EXPECT_EQ(rightShare(sides), 1.0);
}

TEST(SampleSides, AreAboutOneAwayFromTheAxisOnThinPartsToo)
{
  const std::vector<Index> partners = truePartners(human());
  const std::vector<float> sides = sidesUnder(human(), partners);
  double square = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    square += sides[i] * sides[i] / static_cast<float>(sides.size());
    const float way = distance(human().coarse.points[i], human().surface.points[partners[i]]);
    if (way > 6.0F * sampleSpacing(human().coarse)) {
      EXPECT_NEAR(std::abs(sides[i]), 1.1F, 0.35F) << i;
    }
  }
  EXPECT_NEAR(square, 1.0, 1e-3);
}

TEST(SampleSides, StayRightWhereTheMapIsWrongInPlaces)
{
  std::vector<Index> partners = truePartners(human());
  std::mt19937 random(5);
  for (int patch = 0; patch < 12; ++patch) { // around a sample everything goes to one wrong place
    const std::size_t centre = random() % partners.size();
    const Index wrong = human().coarse.cells.vertices[random() % partners.size()];
    for (std::size_t i = 0; i < partners.size(); ++i) {
      if (distance(human().coarse.points[i], human().coarse.points[centre]) < 2.0F * sampleSpacing(human().coarse)) {
        partners[i] = wrong;
      }
    }
  }
  EXPECT_GT(rightShare(sidesUnder(human(), partners)), 0.97);
}

TEST(SampleSides, DoNotSwapAtAWaistThatTheMapLeavesOut)
{
  // All around the middle of the body partners are the points themselves.
  std::vector<Index> partners = truePartners(human());
  const Model at_rest = body(Body::Human, 0.0);
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const Index v = human().coarse.cells.vertices[i];
    const Vector3& rest = at_rest.surface.points[v];
    if (std::abs(rest[0]) < 0.3F && std::abs(rest[1] - 1.05F) < 0.05F) {
      partners[i] = v;
      ++left_out;
    }
  }
  EXPECT_GT(left_out, 15U);
  EXPECT_GT(rightShare(sidesUnder(human(), partners)), 0.98);
}

TEST(SampleSides, KeepTheirNamesUnderMotionScaleAndOrder)
{
  const std::vector<float> sides = sidesUnder(human(), truePartners(human()));
  const std::size_t n = human().model.surface.points.size();
  CoarseBody moved;
  moved.model = human().model;
  const auto to = [n](Index v) {
    return static_cast<Index>((static_cast<std::size_t>(v) * 7 + 3) % n);
  };
  ASSERT_NE(n % 7, 0U);
  for (std::size_t v = 0; v < n; ++v) {
    const Vector3& p = human().model.surface.points[v];
    const Index w = to(static_cast<Index>(v));
    moved.model.surface.points[w] = {5.0F - 300.0F * p[1], 300.0F * p[0], 300.0F * p[2] + 70.0F};
    moved.model.partners[w] = to(human().model.partners[v]);
  }
  for (Triangle& t : moved.model.surface.triangles) {
    t = {to(t[0]), to(t[1]), to(t[2])};
  }
  moved.surface = preparedMesh(moved.model.surface);
  moved.coarse = coarsenSurface(moved.surface, 700);
  moved.basis = laplacianBasis(moved.coarse, 40);
  moved.landmarks = makeLandmarkSurface(moved.coarse, 250, Metric::Geodesic);
  const std::vector<float> moved_sides = sidesUnder(moved, truePartners(moved));

  std::vector<float> at_vertex(n, 0.0F);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    at_vertex[to(human().coarse.cells.vertices[i])] = sides[i];
  }
  std::size_t common = 0;
  for (std::size_t i = 0; i < moved_sides.size(); ++i) {
    const float before = at_vertex[moved.coarse.cells.vertices[i]];
    if (std::abs(before) > 0.5F) {
      EXPECT_GT(before * moved_sides[i], 0.0F) << i;
      ++common;
    }
  }
  EXPECT_GT(common, 100U);
}

TEST(SampleSides, NothingThatMovesHasNoSides)
{
  EXPECT_EQ(sidesUnder(human(), human().coarse.cells.vertices), std::vector<float>(human().coarse.size(), 0.0F));
}

TEST(SampleSides, AMapToOnePlaceIsSurvived)
{
  for (const float side : sidesUnder(human(), std::vector<Index>(human().coarse.size(), 0))) {
    EXPECT_TRUE(std::isfinite(side));
  }
}

} // namespace
