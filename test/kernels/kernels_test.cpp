#include "kernels/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace pcl::symmetry;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** Numbers whose sums and products need rounding. */
std::vector<float>
randomNumbers(std::size_t count, unsigned seed, float low, float high)
{
  std::mt19937 random(seed);
  std::vector<float> numbers(count);
  for (float& x : numbers) {
    x = low + (high - low) * static_cast<float>(random()) / static_cast<float>(random.max());
  }
  return numbers;
}

/** Targets and queries as the kernel takes them. */
struct RowProblem {
  std::size_t targets;
  std::size_t dimensions;
  std::vector<float> packed_targets;
  std::vector<float> half_norms;
  std::vector<float> queries;

  RowProblem(std::size_t target_count, std::size_t dimension_count, unsigned seed)
      : targets(target_count),
        dimensions(dimension_count),
        packed_targets(blocks() * dimensions * kernel_lanes),
        half_norms(blocks() * kernel_lanes, infinity),
        queries(randomNumbers(dimensions * kernel_queries, seed + 1, -1.0F, 1.0F))
  {
    const std::vector<float> values = randomNumbers(targets * dimensions, seed, -1.0F, 1.0F);
    for (std::size_t t = 0; t < targets; ++t) {
      half_norms[t] = 0.0F;
      for (std::size_t d = 0; d < dimensions; ++d) {
        at(t, d) = values[t * dimensions + d];
        half_norms[t] += 0.5F * at(t, d) * at(t, d);
      }
    }
  }

  std::size_t
  blocks() const
  {
    return (targets + kernel_lanes - 1) / kernel_lanes;
  }

  float&
  at(std::size_t t, std::size_t d)
  {
    return packed_targets[(t / kernel_lanes * dimensions + d) * kernel_lanes + t % kernel_lanes];
  }

  std::vector<std::int32_t>
  solve(const KernelTable& table) const
  {
    std::vector<std::int32_t> nearest(kernel_queries, -1);
    table.nearest_rows(queries.data(), packed_targets.data(), half_norms.data(), blocks(), dimensions, nearest.data());
    return nearest;
  }

  /** The definition, word for word. */
  std::vector<std::int32_t>
  expected()
  {
    std::vector<std::int32_t> nearest;
    for (std::size_t q = 0; q < kernel_queries; ++q) {
      float least = infinity;
      std::int32_t best = 0;
      for (std::size_t t = 0; t < targets; ++t) {
        float product = 0.0F;
        for (std::size_t d = 0; d < dimensions; ++d) {
          product += at(t, d) * queries[d * kernel_queries + q];
        }
        const float value = half_norms[t] - product;
        if (value < least) {
          least = value;
          best = static_cast<std::int32_t>(t);
        }
      }
      nearest.push_back(best);
    }
    return nearest;
  }
};

class Kernels : public testing::TestWithParam<InstructionSet> {
protected:
  const KernelTable& table = kernelsFor(GetParam());
};

TEST_P(Kernels, FindTheNearestRows)
{
  for (const std::size_t targets : {1U, 15U, 16U, 17U, 100U, 301U}) {
    for (const std::size_t dimensions : {1U, 2U, 7U, 26U, 88U}) {
      RowProblem problem(targets, dimensions, static_cast<unsigned>(100 * targets + dimensions));
      EXPECT_EQ(problem.solve(table), problem.expected()) << targets << " targets, " << dimensions << " dimensions";
    }
  }
}

TEST_P(Kernels, GiveTiesBetweenRowsToTheLowest)
{
  RowProblem problem(77, 5, 3);
  for (const std::size_t copy : {20U, 21U, 60U, 76U}) { // other lanes and other blocks
    for (std::size_t d = 0; d < problem.dimensions; ++d) {
      problem.at(copy, d) = problem.at(9, d);
    }
    problem.half_norms[copy] = problem.half_norms[9];
  }
  for (std::size_t d = 0; d < problem.dimensions; ++d) {
    problem.queries[d * kernel_queries + 4] = problem.at(9, d);
  }
  EXPECT_EQ(problem.solve(table), problem.expected());
  EXPECT_EQ(problem.solve(table)[4], 9);
  std::fill(problem.packed_targets.begin(), problem.packed_targets.end(), 0.0F);
  std::fill_n(problem.half_norms.begin(), problem.targets, 1.0F);
  EXPECT_EQ(problem.solve(table), std::vector<std::int32_t>(kernel_queries, 0));
}

TEST_P(Kernels, MultiplyOverMinAndPlus)
{
  for (const std::size_t rows : {4U, 8U, 12U, 16U, 44U}) {
    for (const std::size_t depth : {0U, 1U, 5U, 33U}) {
      for (const std::size_t columns : {16U, 48U}) {
        const std::size_t left_stride = rows + 3;
        const std::size_t stride = columns + 5;
        const std::vector<float> left = randomNumbers(depth * left_stride, 1, 0.0F, 9.0F);
        const std::vector<float> right = randomNumbers(depth * stride, 2, 0.0F, 9.0F);
        const std::vector<float> before = randomNumbers(rows * stride, 3, 1.0F, 9.0F);
        std::vector<float> expected = before;
        for (std::size_t i = 0; i < rows; ++i) {
          for (std::size_t j = 0; j < columns; ++j) {
            for (std::size_t k = 0; k < depth; ++k) {
              expected[i * stride + j] =
                  std::min(expected[i * stride + j], left[k * left_stride + i] + right[k * stride + j]);
            }
          }
        }
        std::vector<float> result = before;
        table.min_plus(result.data(), stride, left.data(), left_stride, right.data(), stride, rows, depth, columns);
        EXPECT_EQ(result, expected) << rows << " x " << depth << " x " << columns;
      }
    }
  }
}

TEST_P(Kernels, MultiplyWithPickedRows)
{
  constexpr std::size_t rows = 20;
  constexpr std::size_t depth = 7;
  const std::vector<std::uint32_t> picked{4, 0, 9, 9, 2, 1, 30};
  const std::vector<float> left = randomNumbers(depth * rows, 1, 0.0F, 9.0F);
  const std::vector<float> right = randomNumbers(31 * kernel_lanes, 2, 0.0F, 9.0F);
  std::vector<float> gathered;
  for (const std::uint32_t row : picked) {
    gathered.insert(gathered.end(), right.begin() + row * kernel_lanes, right.begin() + (row + 1) * kernel_lanes);
  }
  std::vector<float> expected(rows * kernel_lanes, infinity);
  std::vector<float> result = expected;
  table.min_plus(expected.data(), kernel_lanes, left.data(), rows, gathered.data(), kernel_lanes, rows, depth,
                 kernel_lanes);
  table.min_plus_picked(result.data(), left.data(), rows, right.data(), picked.data(), rows, depth, kernel_lanes);
  EXPECT_EQ(result, expected);
}

TEST_P(Kernels, CloseATile)
{
  constexpr std::size_t stride = kernel_lanes + 2;
  std::vector<float> tile = randomNumbers(kernel_lanes * stride, 5, 0.0F, 1.0F);
  for (float& length : tile) {
    length = length < 0.7F ? infinity : length; // most pairs have no edge
  }
  for (std::size_t i = 0; i < kernel_lanes; ++i) {
    tile[i * stride + i] = 0.0F;
  }
  std::vector<float> expected = tile;
  for (std::size_t k = 0; k < kernel_lanes; ++k) {
    for (std::size_t i = 0; i < kernel_lanes; ++i) {
      for (std::size_t j = 0; j < kernel_lanes; ++j) {
        expected[i * stride + j] =
            std::min(expected[i * stride + j], expected[i * stride + k] + expected[k * stride + j]);
      }
    }
  }
  table.close_tile(tile.data(), stride);
  EXPECT_EQ(tile, expected);
}

TEST_P(Kernels, TransposeATile)
{
  const std::vector<float> tile = randomNumbers(kernel_lanes * kernel_lanes, 6, 0.0F, 1.0F);
  std::vector<float> result(tile.size());
  const float* rows[kernel_lanes];
  float* columns[kernel_lanes];
  for (std::size_t i = 0; i < kernel_lanes; ++i) {
    rows[i] = tile.data() + i * kernel_lanes;
    columns[i] = result.data() + i * kernel_lanes;
  }
  table.transpose_tile(rows, columns);
  for (std::size_t i = 0; i < kernel_lanes; ++i) {
    for (std::size_t j = 0; j < kernel_lanes; ++j) {
      EXPECT_EQ(result[j * kernel_lanes + i], tile[i * kernel_lanes + j]);
    }
  }
}

/** Sum in the order of the definition. */
float
interleavedSum(const std::vector<float>& terms)
{
  float sums[kernel_lanes] = {};
  for (std::size_t i = 0; i < terms.size(); ++i) {
    sums[i % kernel_lanes] += terms[i];
  }
  for (std::size_t half = kernel_lanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) {
      sums[i] += sums[i + half];
    }
  }
  return sums[0];
}

float
sumOfSquares(std::vector<float> differences)
{
  for (float& difference : differences) {
    difference *= difference;
  }
  return interleavedSum(differences);
}

TEST_P(Kernels, AddUpWeightedDistancesInOneOrder)
{
  constexpr std::size_t count = 5;
  for (const std::size_t padded : {16U, 48U, 64U, 112U, 192U}) {
    const std::vector<float> query = randomNumbers(padded, 1, 0.0F, 1.0F);
    const std::vector<float> candidates = randomNumbers(count * padded, 2, 0.0F, 1.0F);
    const std::vector<float> weights = randomNumbers(padded, 3, 1.0F, 50.0F);
    const std::vector<float> upper = randomNumbers(count * padded, 4, 1.0F, 1.2F);
    for (const std::size_t asked : {std::size_t{1}, count}) {
      std::vector<float> to_points(count, -1.0F);
      std::vector<float> to_boxes(count, -1.0F);
      table.weighted_distances(query.data(), candidates.data(), asked, weights.data(), padded, to_points.data());
      table.weighted_box_distances(query.data(), candidates.data(), upper.data(), asked, weights.data(), padded,
                                   to_boxes.data());
      for (std::size_t c = 0; c < count; ++c) {
        std::vector<float> inside(padded);
        std::vector<float> outside(padded);
        for (std::size_t i = 0; i < padded; ++i) {
          const float lower = candidates[c * padded + i];
          inside[i] = (query[i] - lower) * weights[i];
          outside[i] = std::max(std::max(lower - query[i], query[i] - upper[c * padded + i]), 0.0F) * weights[i];
        }
        EXPECT_EQ(to_points[c], c < asked ? sumOfSquares(inside) : -1.0F);
        EXPECT_EQ(to_boxes[c], c < asked ? sumOfSquares(outside) : -1.0F);
        EXPECT_LE(to_boxes[c], to_points[c]);
      }
    }
  }
}

TEST_P(Kernels, AddUpMomentsOfASlabInOneOrder)
{
  constexpr std::size_t padded = 48;
  constexpr float radius = 0.7F; // some points are outside
  const std::vector<float> points = randomNumbers(3 * padded, 1, -0.5F, 0.5F);
  const std::vector<float> centre = randomNumbers(3, 2, -0.1F, 0.1F);
  const auto biweight = [](float squared) {
    return std::pow(std::max(1.0F - squared, 0.0F), 2.0F);
  };
  for (const std::vector<float>& normal : {std::vector<float>{0.0F, 0.0F, 0.0F}, {1.5F, -2.0F, 0.5F}}) {
    std::vector<std::vector<float>> terms(slab_moment_count);
    for (std::size_t i = 0; i < padded; ++i) {
      std::vector<float> x(3);
      for (std::size_t c = 0; c < 3; ++c) {
        x[c] = (points[c * padded + i] - centre[c]) * (1.0F / radius);
      }
      const float height = x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2];
      const float weight = biweight(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) * biweight(height * height);
      std::size_t m = 0;
      terms[m++].push_back(weight);
      for (std::size_t c = 0; c < 3; ++c) {
        terms[m++].push_back(weight * x[c]);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t d = c; d < 3; ++d) {
          terms[m++].push_back(weight * x[c] * x[d]);
        }
      }
    }
    std::vector<float> moments(slab_moment_count, -1.0F);
    table.slab_moments(points.data(), padded, centre.data(), radius, normal.data(), moments.data());
    for (std::size_t m = 0; m < slab_moment_count; ++m) {
      EXPECT_EQ(moments[m], interleavedSum(terms[m])) << m;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Kernels, testing::ValuesIn(availableInstructionSets()), [](const auto& set) {
  return std::string(instructionSetName(set.param));
});

TEST(InstructionSets, RiseFromTheBaseline)
{
  const std::vector<InstructionSet> available = availableInstructionSets();
  ASSERT_FALSE(available.empty());
  EXPECT_EQ(available.front(), InstructionSet::Baseline);
  EXPECT_TRUE(std::is_sorted(available.begin(), available.end()));
  EXPECT_NE(std::find(available.begin(), available.end(), instructionSetInUse()), available.end());
}

} // namespace
