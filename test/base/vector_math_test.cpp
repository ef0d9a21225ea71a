#include "base/vector_math.h"

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::symmetry;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

TEST(VectorMath, AddsSubtractsAndScales)
{
  EXPECT_EQ((Vector3{1, 2, 3} + Vector3{10, 20, 30}), (Vector3{11, 22, 33}));
  EXPECT_EQ((Vector3{1, 2, 3} - Vector3{10, 20, 30}), (Vector3{-9, -18, -27}));
  EXPECT_EQ(2.0F * (Vector3{1, -2, 3}), (Vector3{2, -4, 6}));
}

TEST(VectorMath, MultipliesInBothWays)
{
  EXPECT_EQ(dot({1, 2, 3}, {4, 5, 6}), 32.0F);
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vector3{0, 0, 1}));
  EXPECT_EQ(cross({1, 2, 3}, {4, 5, 6}), (Vector3{-3, 6, -3}));
}

TEST(VectorMath, MeasuresLengths)
{
  EXPECT_EQ(norm({2, 3, 6}), 7.0F);
  EXPECT_EQ(distance({1, 1, 1}, {3, 4, 7}), 7.0F);
  EXPECT_EQ(normalized({0, 0, -5}), (Vector3{0, 0, -1}));
  EXPECT_EQ(normalized({0, 0, 0}), (Vector3{0, 0, 0}));
}

TEST(UnitOrZero, HasLengthOneHoweverLongOrShortTheVectorIs)
{
  for (const float length : {1e-42F, 1e-30F, 1.0F, 1e38F}) {
    const Vector3 unit = unitOrZero({0.0F, -3.0F * length, 0.0F});
    EXPECT_EQ(unit, (Vector3{0, -1, 0})) << length;
    EXPECT_NEAR(norm(unitOrZero({length, length, length})), 1.0F, 1e-6F) << length;
  }
}

TEST(UnitOrZero, IsZeroWhereThereIsNoDirection)
{
  EXPECT_EQ(unitOrZero({0, 0, 0}), (Vector3{0, 0, 0}));
  EXPECT_EQ(unitOrZero({1, infinity, 0}), (Vector3{0, 0, 0}));
  EXPECT_EQ(unitOrZero({1, not_a_number, 0}), (Vector3{0, 0, 0}));
  EXPECT_FALSE(isDirection({0.0F, -0.0F, 0.0F}));
  EXPECT_TRUE(isDirection({0.0F, 0.0F, -1e-42F}));
}

TEST(VectorMath, TellsWhatIsFinite)
{
  EXPECT_TRUE(isFinite({1, -2, 3e38F}));
  EXPECT_FALSE(isFinite({1, -infinity, 3}));
  EXPECT_FALSE(isFinite({1, 2, not_a_number}));
  EXPECT_FALSE(isFinite({not_a_number, 2, 3}));
}

} // namespace
