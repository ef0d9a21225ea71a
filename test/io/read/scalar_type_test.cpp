// Numbers of all types in both byte orders, against the bytes that the compiler itself makes of them.
#include "io/read/scalar_type.h"
#include "support/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

template <typename Number>
void
expectLoads(ScalarType type, std::initializer_list<Number> numbers)
{
  EXPECT_EQ(sizeOf(type), sizeof(Number));
  EXPECT_EQ(isInteger(type), std::numeric_limits<Number>::is_integer);
  for (const Number number : numbers)
    for (const bool big_endian : {false, true}) {
      const std::string bytes = Bytes(big_endian).add('x', number).str(); // at an odd address
      EXPECT_EQ(loadScalar<Number>(bytes.data() + 1, big_endian), number);
      EXPECT_EQ(loadFloat(bytes.data() + 1, type, big_endian), static_cast<float>(number));
      if (std::numeric_limits<Number>::is_integer) {
        EXPECT_EQ(loadInteger(bytes.data() + 1, type, big_endian), static_cast<std::int64_t>(number));
      }
    }
}

TEST(ScalarType, LoadsEveryTypeInBothByteOrders)
{
  expectLoads<std::int8_t>(ScalarType::Int8, {0, 1, -1, 127, -128});
  expectLoads<std::uint8_t>(ScalarType::UInt8, {0, 1, 255});
  expectLoads<std::int16_t>(ScalarType::Int16, {0, 258, -2, -32768});
  expectLoads<std::uint16_t>(ScalarType::UInt16, {0, 258, 65535});
  expectLoads<std::int32_t>(ScalarType::Int32, {0, 16909060, -1, std::numeric_limits<std::int32_t>::min()});
  expectLoads<std::uint32_t>(ScalarType::UInt32, {0, 16909060, 4294967295U});
  expectLoads<std::int64_t>(ScalarType::Int64, {0, 72623859790382856, -1});
  expectLoads<std::uint64_t>(ScalarType::UInt64, {0, 72623859790382856U});
  expectLoads<float>(ScalarType::Float32, {0.0F, 0.1F, -1e30F, 1e-40F});
  expectLoads<double>(ScalarType::Float64, {0.0, 0.1, -1e30});
}

TEST(ScalarType, WhatIsTooLargeIsLargest)
{
  const std::string large = Bytes().add(std::numeric_limits<std::uint64_t>::max()).str();
  EXPECT_EQ(loadInteger(large.data(), ScalarType::UInt64, false), std::numeric_limits<std::int64_t>::max());
  const std::string infinite = Bytes().add(1e300).str();
  EXPECT_TRUE(std::isinf(loadFloat(infinite.data(), ScalarType::Float64, false)));
}

TEST(ScalarType, ColumnsSkipWhatIsBetween)
{
  const std::string bytes = Bytes(true).add('x', std::int16_t{5}, 'x', std::int16_t{-6}, 'x', std::int16_t{7}).str();
  std::vector<Vector3> vectors(3, Vector3{1.0F, 1.0F, 1.0F});
  copyColumn({bytes.data() + 1, 3, ScalarType::Int16, true}, 2, vectors);
  EXPECT_EQ(vectors, (std::vector<Vector3>{{1.0F, 1.0F, 5.0F}, {1.0F, 1.0F, -6.0F}, {1.0F, 1.0F, 7.0F}}));
}

TEST(ScalarType, AnOriginIsSubtractedBeforeRounding)
{
  const std::string bytes = Bytes().add(5400000.125).str();
  EXPECT_EQ(loadFloat(bytes.data(), ScalarType::Float64, false, 5400000.0), 0.125F);
  std::vector<Vector3> vectors(1);
  copyColumn({bytes.data(), 8, ScalarType::Float64, false}, 1, vectors, 5400000.0);
  EXPECT_EQ(vectors[0][1], 0.125F);
}

TEST(ScalarType, StoresTheNearestThatTheTypeHolds)
{
  const auto stored = [](ScalarType type, double value) {
    std::string bytes(sizeOf(type) + 1, 'x');
    storeScalar(bytes.data() + 1, type, value); // at an odd address
    return loadInteger(bytes.data() + 1, type, false);
  };
  EXPECT_EQ(stored(ScalarType::UInt8, 200.0), 200);
  EXPECT_EQ(stored(ScalarType::UInt8, -1.0), 0);
  EXPECT_EQ(stored(ScalarType::Int16, 1e9), 32767);
  EXPECT_EQ(stored(ScalarType::UInt32, 4294967295.0), 4294967295);
  EXPECT_EQ(stored(ScalarType::Int64, -1e300), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(stored(ScalarType::Int32, std::nan("")), 0);
  char bytes[sizeof(double)];
  storeScalar(bytes, ScalarType::Float64, 0.1);
  EXPECT_EQ(loadScalar<double>(bytes, false), 0.1);
}

TEST(ScalarType, KindsAreThoseOfPcd)
{
  EXPECT_EQ(kindOf(ScalarType::Float64), 'F');
  EXPECT_EQ(kindOf(ScalarType::Int16), 'I');
  EXPECT_EQ(kindOf(ScalarType::UInt64), 'U');
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
