// What must not change a result: order of the points, scale, place, mirror, number of threads, time of day.
#include "model/random_numbers.h"
#include "support/known_body.h"
#include "support/same_result.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const Model&
posedHuman()
{
  static const Model model = body(Body::Human, 0.3);
  return model;
}

SymmetryParameters
parametersOf(Method method)
{
  SymmetryParameters parameters;
  parameters.method = method;
  return parameters;
}

const SymmetryResult&
resultOfPosedHuman(Method method)
{
  static const SymmetryResult robust = estimateIntrinsicSymmetry(posedHuman().surface, parametersOf(Method::Robust));
  static const SymmetryResult staged = estimateIntrinsicSymmetry(posedHuman().surface, parametersOf(Method::Staged));
  return method == Method::Robust ? robust : staged;
}

/** Mean geodesic distance of the partners of two maps, share of the diameter. */
double
difference(const Surface& surface, const std::vector<Index>& a, const std::vector<Index>& b, float diameter)
{
  const SurfaceGraph graph = meshGraph(surface);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < a.size(); v += 7, ++count) {
    sum += distanceField(graph, a[v])[b[v]];
  }
  return sum / static_cast<double>(count) / diameter;
}

class SameMapTest : public testing::TestWithParam<Method> {
protected:
  /** The map of a changed surface, whose points are in the old order, is the old one but for rounding, which may send
   * a few points to a neighbour of their old partners: 0.5 % of the diameter on average. */
  void
  expectSameMap(const Surface& changed, float scale = 1.0F) const
  {
    const SymmetryResult& before = resultOfPosedHuman(GetParam());
    const SymmetryResult after = estimateIntrinsicSymmetry(changed, parametersOf(GetParam()));
    ASSERT_EQ(before.status, SymmetryStatus::Symmetric) << before.message;
    ASSERT_EQ(after.status, SymmetryStatus::Symmetric) << after.message;
    EXPECT_LT(difference(posedHuman().surface, before.partners, after.partners, before.diameter), 0.005);
    EXPECT_NEAR(after.diameter / scale, before.diameter, 0.01F * before.diameter);
    EXPECT_NEAR(after.confidence, before.confidence, 0.05F);
  }
};

TEST_P(SameMapTest, AnyNumberOfThreads)
{
  SymmetryParameters parameters = parametersOf(GetParam());
  for (const unsigned threads : {1U, 2U, 5U}) {
    SCOPED_TRACE(threads);
    parameters.threads = threads;
    expectSameBytes(estimateIntrinsicSymmetry(posedHuman().surface, parameters), resultOfPosedHuman(GetParam()));
  }
}

TEST_P(SameMapTest, RunAgain)
{
  expectSameBytes(estimateIntrinsicSymmetry(posedHuman().surface, parametersOf(GetParam())),
                  resultOfPosedHuman(GetParam()));
}

TEST_P(SameMapTest, TinyAndHuge)
{
  for (const float scale : {1e-6F, 1e6F}) {
    SCOPED_TRACE(scale);
    expectSameMap(scaled(posedHuman().surface, {scale, scale, scale}), scale);
  }
}

TEST_P(SameMapTest, TurnedAndMoved)
{
  Surface moved = posedHuman().surface;
  for (Vector3& p : moved.points) {
    p = {0.6F * p[0] - 0.8F * p[2] + 3.0F, p[1] - 7.0F, 0.8F * p[0] + 0.6F * p[2] + 5.0F};
  }
  expectSameMap(moved);
}

TEST_P(SameMapTest, FarFromTheOrigin)
{
  Surface moved = posedHuman().surface;
  for (Vector3& p : moved.points) {
    p = p + Vector3{100.0F, -200.0F, 50.0F};
  }
  expectSameMap(moved);
}

TEST_P(SameMapTest, Mirrored)
{
  Surface mirrored = scaled(posedHuman().surface, {-1.0F, 1.0F, 1.0F});
  for (Triangle& t : mirrored.triangles) {
    std::swap(t[1], t[2]);
  }
  expectSameMap(mirrored);
}

TEST_P(SameMapTest, TurnedInsideOut)
{
  Surface inside_out = posedHuman().surface;
  for (Triangle& t : inside_out.triangles) {
    std::swap(t[1], t[2]);
  }
  expectSameMap(inside_out);
}

TEST_P(SameMapTest, PointsInAnotherOrder)
{
  const Surface& surface = posedHuman().surface;
  std::vector<Index> new_number(surface.size());
  std::iota(new_number.begin(), new_number.end(), 0);
  RandomNumbers(5).shuffle(new_number);
  Surface shuffled = surface;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    shuffled.points[new_number[v]] = surface.points[v];
  }
  for (Triangle& t : shuffled.triangles) {
    t = {new_number[t[0]], new_number[t[1]], new_number[t[2]]};
  }
  const SymmetryResult& before = resultOfPosedHuman(GetParam());
  const SymmetryResult after = estimateIntrinsicSymmetry(shuffled, parametersOf(GetParam()));
  ASSERT_EQ(after.status, SymmetryStatus::Symmetric) << after.message;
  std::vector<Index> old_number(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    old_number[new_number[v]] = static_cast<Index>(v);
  }
  std::vector<Index> partners(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    partners[v] = old_number[after.partners[new_number[v]]];
  }
  // Ties are decided otherwise, so samples and partners shift by about their spacing.
  EXPECT_LT(difference(surface, before.partners, partners, before.diameter), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         SameMapTest,
                         testing::Values(Method::Robust, Method::Staged),
                         [](const testing::TestParamInfo<Method>& tested) {
                           return tested.param == Method::Robust ? "Robust" : "Staged";
                         });

} // namespace
