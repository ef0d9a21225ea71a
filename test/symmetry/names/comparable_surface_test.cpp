#include "support/named_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const ComparableSurface&
bentHumanDescribed()
{
  static const ComparableSurface surface = namedBody(human(), Body::Human);
  return surface;
}

TEST(ComparableSurface, FeaturesAndDistancesAreAlikeAtPartners)
{
  const ComparableSurface& surface = bentHumanDescribed();
  ASSERT_TRUE(surface.isComparable());
  EXPECT_NEAR(surface.distances.mean(), 1.0, 1e-3);
  const SampleMap map = trueSampleMap(human());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[static_cast<std::size_t>(map[i])] == static_cast<Index>(i)) {
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_TRUE(surface.features.row(row).isApprox(surface.features.row(map[i]), 1e-9)) << i;
      EXPECT_TRUE(surface.distances.row(row).isApprox(surface.distances.row(map[i]))) << i;
    }
  }
}

TEST(ComparableSurface, TurnsChangeTheirSignWithTheNames)
{
  const ComparableSurface& surface = bentHumanDescribed();
  std::vector<float> exchanged = leftAsSource(human(), Body::Human);
  std::transform(exchanged.begin(), exchanged.end(), exchanged.begin(), std::negate<>());
  const ComparableSurface other = comparableSurface(human().sampled(), trueSampleMap(human()), exchanged);
  const Eigen::MatrixXd turns = turnsOf(surface, surface.even.functions.leftCols(4));
  ASSERT_EQ(turns.cols(), 6);
  EXPECT_GT(turns.norm(), 1.0);
  EXPECT_TRUE(turnsOf(other, surface.even.functions.leftCols(4)).isApprox(-turns));
  EXPECT_NEAR(other.chirality, -surface.chirality, 1e-9);
}

TEST(ComparableSurface, TurnsOfEvenFunctionsAreMostlyAlikeAtPartners)
{
  const ComparableSurface& surface = bentHumanDescribed();
  const Eigen::MatrixXd turns = turnsOf(surface, surface.even.functions.leftCols(4));
  const SampleMap map = trueSampleMap(human());
  double alike = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double product = turns.row(static_cast<Eigen::Index>(i)).dot(turns.row(map[i]));
    alike += product;
    all += std::abs(product);
  }
  EXPECT_GT(alike, 0.8 * all);
}

TEST(ComparableSurface, DoesNotDependOnWhereFacesPoint)
{
  SampledSurface inwards = human().sampled();
  for (Vector3& normal : inwards.coarse.normals) {
    normal = -1.0F * normal;
  }
  inwards.descriptor.curvature *= -1.0F;
  for (Triangle& t : inwards.coarse.triangles) {
    std::swap(t[1], t[2]);
  }
  const ComparableSurface& surface = bentHumanDescribed();
  const ComparableSurface other =
      comparableSurface(inwards, trueSampleMap(human()), leftAsSource(human(), Body::Human));
  EXPECT_TRUE(other.features.isApprox(surface.features, 1e-6));
  const Eigen::MatrixXd functions = surface.even.functions.leftCols(3);
  EXPECT_TRUE(turnsOf(other, functions).isApprox(turnsOf(surface, functions), 1e-9));
}

TEST(ComparableSurface, OfTooFewSamplesIsNotComparable)
{
  EXPECT_FALSE(ComparableSurface{}.isComparable());
}

} // namespace
