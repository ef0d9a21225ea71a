#include "base/thread_scope.h"
#include "support/named_body.h"
#include "symmetry/names/name_comparison.h"

#include <gtest/gtest.h>

#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** The same with the names exchanged. */
ComparableSurface
exchanged(ComparableSurface surface)
{
  surface.sides *= -1.0;
  surface.chirality *= -1.0;
  return surface;
}

/** What the maps alone say. */
double
byMaps(const NameComparison& comparison)
{
  NameComparison maps = comparison;
  maps.chiralities = 0.0;
  return maps.margin();
}

class NamesOfBodies : public testing::TestWithParam<Body> {};

TEST_P(NamesOfBodies, AreTheSameInAnotherPoseAndOppositeWhenExchanged)
{
  const ComparableSurface reference = namedBody(GetParam(), 0.3, 1);
  for (const std::uint64_t seed : {2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ComparableSurface posed = namedBody(GetParam(), 1.0, seed);
    const NameComparison same = compareNames(reference, posed);
    EXPECT_GT(byMaps(same), 0.1);
    EXPECT_LT(same.same, 0.7);
    const NameComparison opposite = compareNames(reference, exchanged(posed));
    EXPECT_DOUBLE_EQ(opposite.same, same.opposite);
    EXPECT_DOUBLE_EQ(opposite.opposite, same.same);
    EXPECT_DOUBLE_EQ(opposite.margin(), -same.margin());
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         NamesOfBodies,
                         testing::Values(Body::Human, Body::Quadruped, Body::Bird),
                         [](const testing::TestParamInfo<Body>& kind) { return std::string(toString(kind.param)); });

TEST(NameComparison, DoesNotDependOnTheNumberOfThreads)
{
  const ComparableSurface first = namedBody(Body::Quadruped, 0.3, 1);
  const ComparableSurface second = namedBody(Body::Quadruped, 1.0, 2);
  const auto with = [&](unsigned threads) {
    const ThreadScope scope(threads);
    return compareNames(first, second);
  };
  const NameComparison one = with(1);
  const NameComparison three = with(3);
  EXPECT_EQ(one.same, three.same);
  EXPECT_EQ(one.opposite, three.opposite);
}

TEST(NameComparison, SaysNothingOfWhatCannotBeCompared)
{
  EXPECT_EQ(compareNames({}, namedBody(Body::Human, 0.3, 1)).margin(), 0.0);
}

TEST(NameComparison, MarginIsAShareOfTheWorseFitAndALittleOfTheChiralities)
{
  EXPECT_DOUBLE_EQ((NameComparison{0.2, 0.8, 0.0}).margin(), 0.75);
  EXPECT_DOUBLE_EQ((NameComparison{0.8, 0.2, 0.0}).margin(), -0.75);
  EXPECT_NEAR((NameComparison{0.5, 0.5, -1.0}).margin(), -0.15, 1e-12);
  EXPECT_DOUBLE_EQ((NameComparison{0.0, 1.0, 1.0}).margin(), 1.0);
  // Below what can be told the chiralities have the say, above it they have not.
  EXPECT_NEAR((NameComparison{0.5, 0.45, 0.2}).margin(), 0.07, 1e-12);
  EXPECT_NEAR((NameComparison{0.5, 0.4, 0.2}).margin(), -0.17, 1e-12);
  EXPECT_NEAR((NameComparison{0.5, 0.45, 0.0}).margin(), -0.1, 1e-12);
}

} // namespace
