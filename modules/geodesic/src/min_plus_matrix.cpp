#include "geodesic/min_plus_matrix.h"

#include "base/parallel.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

void
minPlus(float* result,
        std::size_t result_stride,
        const float* left,
        std::size_t left_stride,
        const float* right,
        std::size_t right_stride,
        std::size_t rows,
        std::size_t depth,
        std::size_t columns)
{
  constexpr std::size_t worth_threads = 4000000; // about 0.2 ms
  const std::size_t parts = rows * depth * columns < worth_threads ? 1 : 2 * threadCount(columns);
  const std::size_t grain = roundedUp(std::max<std::size_t>(1, (columns + parts - 1) / parts), kernel_lanes);
  parallelBlocks(columns, grain, [&] {
    return [&](std::size_t begin, std::size_t end) {
      kernels().min_plus(result + begin, result_stride, left, left_stride, right + begin, right_stride, rows, depth,
                         end - begin);
    };
  });
}

void
closeSymmetric(float* matrix, std::size_t count, std::size_t stride, FloatBlock& panel_memory)
{
  const KernelTable& table = kernels();
  float* panel = panel_memory.reserve(kernel_lanes * stride);
  for (std::size_t k = 0; k < count; k += kernel_lanes) {
    float* rows = matrix + k * stride;
    table.close_tile(rows + k, stride);
    // Rows k .. of the matrix, with paths through the vertices of the tile; the tile is its own transpose.
    std::copy(rows, rows + kernel_lanes * stride, panel);
    table.min_plus(panel, stride, rows + k, stride, rows, stride, kernel_lanes, kernel_lanes, stride);
    minPlus(matrix, stride, panel, stride, panel, stride, roundedUp(count, min_plus_rows), kernel_lanes, stride);
  }
}

void
transposeBlocks(
    const float* from, std::size_t from_stride, std::size_t rows, std::size_t columns, float* to, std::size_t to_stride)
{
  const KernelTable& table = kernels();
  const float* tile_rows[kernel_lanes];
  float* tile_columns[kernel_lanes];
  for (std::size_t i = 0; i < rows; i += kernel_lanes) {
    for (std::size_t j = 0; j < columns; j += kernel_lanes) {
      for (std::size_t k = 0; k < kernel_lanes; ++k) {
        tile_rows[k] = from + (i + k) * from_stride + j;
        tile_columns[k] = to + (j + k) * to_stride + i;
      }
      table.transpose_tile(tile_rows, tile_columns);
    }
  }
}

void
mirrorUpperTriangle(float* matrix, std::size_t stride)
{
  for (std::size_t i = 0; i < stride; i += kernel_lanes) {
    for (std::size_t row = i; row < i + kernel_lanes; ++row) {
      for (std::size_t column = i; column < row; ++column) {
        matrix[row * stride + column] = matrix[column * stride + row];
      }
    }
    if (i > 0) {
      transposeBlocks(matrix + i, stride, i, kernel_lanes, matrix + i * stride, stride);
    }
  }
}

} // namespace symmetry
} // namespace pcl
