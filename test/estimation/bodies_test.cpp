// From a body to partners, sides and axis, against the truth the body was grown with.
#include "support/known_body.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct Case {
  std::string name;
  Body kind;
  double bend;
  std::uint64_t seed;
  Method method = Method::Robust;
  Metric metric = Metric::Geodesic;
  double mean_error = 0.04; ///< at most, over the square root of the area
};

std::ostream&
operator<<(std::ostream& stream, const Case& body)
{
  return stream << body.name;
}

SymmetryResult
estimate(const Surface& surface, const Case& body)
{
  SymmetryParameters parameters;
  parameters.method = body.method;
  parameters.metric = body.metric;
  return estimateIntrinsicSymmetry(surface, parameters);
}

class BodyTest : public testing::TestWithParam<Case> {};

/** Every array has one entry per point, every number refers to a point. */
void
expectSound(const SymmetryResult& result, std::size_t points)
{
  const auto is_point = [points](Index v) {
    return v >= 0 && static_cast<std::size_t>(v) < points;
  };
  ASSERT_EQ(result.partners.size(), points);
  ASSERT_EQ(result.confidences.size(), points);
  ASSERT_EQ(result.sides.size(), points);
  ASSERT_EQ(result.regions.size(), points);
  for (std::size_t v = 0; v < points; ++v) {
    EXPECT_TRUE(is_point(result.partners[v])) << v;
    EXPECT_TRUE(result.confidences[v] >= 0.0F && result.confidences[v] <= 1.0F) << result.confidences[v];
    EXPECT_NE(result.sides[v], Side::None) << v;
    EXPECT_NE(result.regions[v], Region::None) << v;
  }
  EXPECT_TRUE(result.confidence >= 0.0F && result.confidence <= 1.0F);
  EXPECT_FALSE(result.matches.empty());
  for (const SymmetricMatch& match : result.matches) {
    EXPECT_TRUE(is_point(match.source) && is_point(match.target) && is_point(match.midpoint));
    EXPECT_TRUE(match.cost >= 0.0F && std::isfinite(match.cost));
  }
  EXPECT_TRUE(std::all_of(result.extremities.begin(), result.extremities.end(), is_point));
  EXPECT_EQ(result.map.matched, points);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(result.map.axis),
            std::count(result.sides.begin(), result.sides.end(), Side::Axis));
  EXPECT_GT(result.diameter, 0.0F);
}

/** A curve through neighbours that never leaves the true axis by more than 3 % of the diameter. */
void
expectAxis(const Model& model, const SymmetryResult& result)
{
  const SurfaceGraph graph = meshGraph(model.surface);
  const std::vector<float> from_axis = distanceField(graph, trueAxis(model));
  ASSERT_FALSE(result.axis.empty());
  for (const Polyline& line : result.axis) {
    EXPECT_TRUE(line.closed);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Index next = line.points[(i + 1) % line.points.size()];
      EXPECT_TRUE(areNeighbours(graph, line.points[i], next)) << line.points[i] << ' ' << next;
      EXPECT_LT(from_axis[line.points[i]], 0.03F * result.diameter);
    }
  }
}

TEST_P(BodyTest, PartnersAndSidesAreTheTrueOnes)
{
  const Model model = body(GetParam().kind, GetParam().bend, GetParam().seed);
  const SymmetryResult result = estimate(model.surface, GetParam());
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  expectSound(result, model.surface.size());
  const std::vector<double> errors = mapErrors(model, result.partners);
  EXPECT_GE(correspondenceRate(errors), 0.95);
  EXPECT_LE(mean(errors), GetParam().mean_error);
  EXPECT_GE(shareOnOppositeSides(model, result.sides), 0.95);
  EXPECT_GE(result.confidence, 0.5F);
  EXPECT_EQ(result.input.used, model.surface.size());
  EXPECT_EQ(result.input.components, 1U);
}

TEST_P(BodyTest, AxisIsTheTrueOne)
{
  const Model model = body(GetParam().kind, GetParam().bend, GetParam().seed);
  const SymmetryResult result = estimate(model.surface, GetParam());
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  expectAxis(model, result);
}

TEST_P(BodyTest, MatchesLeadFromTheSourceSideToTheTargetSide)
{
  const Model model = body(GetParam().kind, GetParam().bend, GetParam().seed);
  const SymmetryResult result = estimate(model.surface, GetParam());
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  std::size_t right = 0;
  for (const SymmetricMatch& match : result.matches) {
    right += result.sides[match.source] != Side::Target && result.sides[match.target] != Side::Source ? 1U : 0U;
  }
  EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(result.matches.size()));
}

INSTANTIATE_TEST_SUITE_P(
    Mesh,
    BodyTest,
    testing::Values(Case{"HumanAtRest", Body::Human, 0.0, 1},
                    Case{"HumanPosed", Body::Human, 1.0, 1},
                    Case{"HumanPosedOtherwise", Body::Human, 1.0, 3},
                    Case{"QuadrupedAtRest", Body::Quadruped, 0.0, 1},
                    Case{"QuadrupedPosed", Body::Quadruped, 1.0, 1},
                    Case{"BirdPosed", Body::Bird, 1.0, 1},
                    Case{"HumanStaged", Body::Human, 0.3, 1, Method::Staged},
                    Case{"HumanAtRestEuclidean", Body::Human, 0.0, 1, Method::Robust, Metric::Euclidean},
                    Case{"HumanAtRestStagedEuclidean", Body::Human, 0.0, 1, Method::Staged, Metric::Euclidean}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

} // namespace
