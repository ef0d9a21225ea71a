// Numbers as text that reads back as the same number, and as little-endian bytes.
#include "io/write/record_writer.h"
#include "support/bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

template <typename Number>
std::string
textOf(Number number)
{
  std::string text;
  appendNumber(text, number);
  return text;
}

TEST(RecordWriter, TextIsShortAndReadsBack)
{
  EXPECT_EQ(textOf(0.1F), "0.1");
  EXPECT_EQ(textOf(-2), "-2");
  EXPECT_EQ(textOf(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    float number = 0.0F;
    std::memcpy(&number, &bits, sizeof(number));
    if (!std::isnan(number)) {
      EXPECT_EQ(std::strtof(textOf(number).c_str(), nullptr), number);
    }
  }
}

TEST(RecordWriter, AppendsToWhatIsThere)
{
  std::string text = "a,";
  appendNumber(text, 7);
  appendBytes(text, 'z');
  EXPECT_EQ(text, "a,7z");
}

TEST(RecordWriter, BytesAreLittleEndian)
{
  std::string bytes;
  appendBytes(bytes, std::uint32_t{0x04030201});
  appendBytes(bytes, std::int16_t{-2});
  EXPECT_EQ(bytes, "\x01\x02\x03\x04\xFE\xFF");
  std::string vector;
  appendBytes(vector, std::array<float, 2>{0.5F, -1.5F});
  EXPECT_EQ(vector, Bytes().add(0.5F, -1.5F).str());
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
