/** \file
 * \brief Matrices of distances: row-major, strides rounded up to whole blocks of kernel_lanes, filled up with infinity.
 */
#pragma once

#include "base/large_memory.h"
#include "kernels/kernels.h"

#include <cstddef>
#include <limits>

namespace pcl {
namespace symmetry {

/** \brief No way. */
constexpr float infinity = std::numeric_limits<float>::infinity();

inline std::size_t
roundedUp(std::size_t count, std::size_t multiple)
{
  return (count + multiple - 1) / multiple * multiple;
}

/** \brief KernelTable::min_plus, its columns shared out among threads where that is worth their start. */
void
minPlus(float* result,
        std::size_t result_stride,
        const float* left,
        std::size_t left_stride,
        const float* right,
        std::size_t right_stride,
        std::size_t rows,
        std::size_t depth,
        std::size_t columns);

/** \brief Shortest paths among all pairs, in place: Floyd's algorithm \cite floyd1962algorithm by blocks.
 * \param[in,out] matrix symmetric, count x count; the stride is a multiple of kernel_lanes
 *
 * \param[in] panel scratch */
void
closeSymmetric(float* matrix, std::size_t count, std::size_t stride, FloatBlock& panel);

/** \brief Transposes a matrix whose rows and columns are whole blocks of kernel_lanes. */
void
transposeBlocks(const float* from,
                std::size_t from_stride,
                std::size_t rows,
                std::size_t columns,
                float* to,
                std::size_t to_stride);

/** \brief Makes a matrix symmetric of which only the upper triangle is filled in. */
void
mirrorUpperTriangle(float* matrix, std::size_t stride);

} // namespace symmetry
} // namespace pcl
