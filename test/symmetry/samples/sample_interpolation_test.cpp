#include "support/coarse_body.h"
#include "support/with_threads.h"
#include "symmetry/samples/sample_interpolation.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct Plane {
  PreparedSurface surface = preparedMesh(gridMesh(60, 60));
  CoarseSurface coarse = coarsenSurface(surface, 300);
  SampleInterpolation interpolation = interpolateFromSamples(surface, coarse);
};

TEST(SampleInterpolation, WeightsSumUpToOne)
{
  const CoarseBody human = coarseBody(Body::Human, 1.0);
  const SampleInterpolation interpolation =
      withThreads(2, [&] { return interpolateFromSamples(human.surface, human.coarse); });
  ASSERT_EQ(interpolation.offsets.size(), human.surface.size() + 1);
  const std::vector<float> ones(human.coarse.size(), 1.0F);
  for (std::size_t v = 0; v < human.surface.size(); ++v) {
    EXPECT_NEAR(interpolation.at(v, ones), 1.0F, 1e-3F);
  }
}

TEST(SampleInterpolation, ReproducesLinearFunctionsOnAPlane)
{
  const Plane plane;
  const auto linear = [](const Vector3& p) {
    return 0.3F + 2.0F * p[0] - 1.5F * p[1];
  };
  std::vector<float> values;
  for (const Vector3& p : plane.coarse.points) {
    values.push_back(linear(p));
  }
  float largest_error = 0.0F;
  for (std::size_t v = 0; v < plane.surface.size(); ++v) {
    const Vector3& p = plane.surface.points[v];
    if (std::max(std::abs(p[0]), std::abs(p[1])) < 0.4F) { // where samples lie on all sides
      largest_error = std::max(largest_error, std::abs(plane.interpolation.at(v, values) - linear(p)));
    }
  }
  // The function changes by 2.5 over the unit of length; samples are 0.06 apart, which is 0.15. Damping costs a little.
  EXPECT_LT(largest_error, 0.02F);
}

TEST(SampleInterpolation, RowsAreInterpolatedAsValuesAre)
{
  const Plane plane;
  Eigen::MatrixXf rows(static_cast<Eigen::Index>(plane.coarse.size()), 2);
  std::vector<float> second;
  for (std::size_t i = 0; i < plane.coarse.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) << plane.coarse.points[i][0], plane.coarse.points[i][1];
    second.push_back(plane.coarse.points[i][1]);
  }
  for (std::size_t v = 0; v < plane.surface.size(); v += 17) {
    EXPECT_NEAR(plane.interpolation.at(v, rows)(1), plane.interpolation.at(v, second), 1e-5F);
  }
}

TEST(SampleInterpolation, IsTheSameForAnyNumberOfThreads)
{
  const CoarseBody human = coarseBody(Body::Human, 1.0);
  const SampleInterpolation one = interpolateFromSamples(human.surface, human.coarse);
  const SampleInterpolation five = withThreads(5, [&] { return interpolateFromSamples(human.surface, human.coarse); });
  EXPECT_EQ(one.offsets, five.offsets);
  EXPECT_EQ(one.samples, five.samples);
  EXPECT_EQ(one.weights, five.weights);
}

} // namespace
