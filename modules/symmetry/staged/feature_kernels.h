/** \file
 * \brief The order in which the terms of a dissimilarity are added up.
 */
#pragma once

#include "kernels/kernel_table.h"

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Feature vectors are padded with zero-weight features to a multiple of this. */
constexpr std::size_t feature_lanes = kernel_lanes;

/** \brief Sum of squares of difference (i), i in [0, padded), in feature_lanes interleaved sums: the definition, bit by
 * bit, of the kernels' weighted distances.
 * \param[in] padded number of differences, a multiple of feature_lanes
 * \param[in] difference function of the feature's number
 */
template <typename Difference>
inline float
sumOfSquares(std::size_t padded, Difference difference)
{
  float lanes[feature_lanes] = {};
  for (std::size_t i = 0; i < padded; ++i) {
    const float d = difference(i);
    lanes[i % feature_lanes] += d * d;
  }
  for (std::size_t half = feature_lanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) {
      lanes[i] += lanes[i + half];
    }
  }
  return lanes[0];
}

} // namespace symmetry
} // namespace pcl
