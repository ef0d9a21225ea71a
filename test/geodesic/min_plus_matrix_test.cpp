#include "geodesic/min_plus_matrix.h"
#include "kernels/kernel_table.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Lengths of the edges of a random graph: whole numbers, so that sums are exact in any order. */
std::vector<float>
randomLengths(std::size_t count, std::size_t stride, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> length(1, 100);
  std::vector<float> matrix(stride * stride, infinity);
  for (std::size_t i = 0; i < stride; ++i) {
    matrix[i * stride + i] = 0.0F;
    for (std::size_t j = 0; j < i && i < count; ++j) {
      if (length(random) <= 20) {
        matrix[i * stride + j] = matrix[j * stride + i] = static_cast<float>(length(random));
      }
    }
  }
  return matrix;
}

/** Floyd's algorithm, one vertex after another. */
std::vector<float>
closed(std::vector<float> matrix, std::size_t count, std::size_t stride)
{
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        matrix[i * stride + j] = std::min(matrix[i * stride + j], matrix[i * stride + k] + matrix[k * stride + j]);
      }
    }
  }
  return matrix;
}

TEST(RoundedUp, GivesTheNextMultiple)
{
  EXPECT_EQ(roundedUp(0, 16), 0U);
  EXPECT_EQ(roundedUp(1, 16), 16U);
  EXPECT_EQ(roundedUp(16, 16), 16U);
  EXPECT_EQ(roundedUp(17, 16), 32U);
}

TEST(CloseSymmetric, FindsTheShortestPathsOfFloydsAlgorithm)
{
  for (const std::size_t count : {1U, 16U, 37U, 96U}) {
    const std::size_t stride = roundedUp(count, kernel_lanes);
    std::vector<float> matrix = randomLengths(count, stride, static_cast<unsigned>(count));
    const std::vector<float> expected = closed(matrix, count, stride);
    FloatBlock panel;
    closeSymmetric(matrix.data(), count, stride, panel);
    EXPECT_EQ(matrix, expected) << count;
  }
}

TEST(CloseSymmetric, GivesTheSameBytesForAnyNumberOfThreads)
{
  constexpr std::size_t count = 640; // enough for several threads
  std::vector<float> alone = randomLengths(count, count, 3);
  std::vector<float> shared = alone;
  FloatBlock panel;
  closeSymmetric(alone.data(), count, count, panel);
  withThreads(3, [&] { closeSymmetric(shared.data(), count, count, panel); });
  EXPECT_EQ(alone, shared);
}

TEST(TransposeBlocks, SwapsRowsAndColumns)
{
  constexpr std::size_t rows = 2 * kernel_lanes;
  constexpr std::size_t columns = 3 * kernel_lanes;
  std::vector<float> from(rows * columns);
  for (std::size_t i = 0; i < from.size(); ++i) {
    from[i] = static_cast<float>(i);
  }
  std::vector<float> to(columns * rows);
  transposeBlocks(from.data(), columns, rows, columns, to.data(), rows);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      ASSERT_EQ(to[j * rows + i], from[i * columns + j]);
    }
  }
}

TEST(MirrorUpperTriangle, FillsInTheLowerOne)
{
  constexpr std::size_t stride = 3 * kernel_lanes;
  std::vector<float> matrix(stride * stride, -1.0F);
  for (std::size_t i = 0; i < stride; ++i) {
    for (std::size_t j = i; j < stride; ++j) {
      matrix[i * stride + j] = static_cast<float>(i * stride + j);
    }
  }
  mirrorUpperTriangle(matrix.data(), stride);
  for (std::size_t i = 0; i < stride; ++i) {
    for (std::size_t j = 0; j < stride; ++j) {
      ASSERT_EQ(matrix[i * stride + j], static_cast<float>(std::min(i, j) * stride + std::max(i, j)));
    }
  }
}

} // namespace
