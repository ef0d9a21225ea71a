#include "base/large_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

using namespace pcl::symmetry;

namespace {

TEST(FloatBlock, BeginsWithACacheLineAndGrows)
{
  FloatBlock block;
  for (const std::size_t count : {0U, 1U, 100U, 2000000U, 50U}) {
    float* floats = block.reserve(count);
    ASSERT_NE(floats, nullptr);
    EXPECT_EQ(floats, block.data());
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(floats) % 64, 0U);
    std::fill_n(floats, count, 1.0F);
  }
  const FloatBlock taken = std::move(block);
  block = FloatBlock();
  std::fill_n(block.reserve(1000), 1000, 2.0F);
  EXPECT_EQ(taken.data()[49], 1.0F);
}

TEST(FloatBlock, KeepsItsMemoryAsLongAsItSuffices)
{
  FloatBlock block;
  const float* floats = block.reserve(1000);
  EXPECT_EQ(block.reserve(10), floats);
  EXPECT_EQ(block.reserve(1000), floats);
}

TEST(PreferLargePages, LeavesWhatIsThereAsItIs)
{
  std::vector<float> floats(3000000, 1.5F);
  for (const std::size_t first : {0U, 1U, 1000U}) { // also where no page begins
    preferLargePages(floats.data() + first, (floats.size() - first) * sizeof(float));
  }
  preferLargePages(floats.data(), 0);
  EXPECT_EQ(std::count(floats.begin(), floats.end(), 1.5F), static_cast<std::ptrdiff_t>(floats.size()));
}

} // namespace
