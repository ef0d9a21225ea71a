/** \file
 * \brief The inner loop of feature matching, shared by the plain dissimilarity and the box tree.
 */
#pragma once

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Feature vectors are padded with zero-weight features to a multiple of this. */
constexpr std::size_t feature_lanes = 8;

/** \brief Sum of squares of difference (i), i in [0, padded), in feature_lanes interleaved sums that a compiler keeps
 * in vector registers.
 *
 * Rounding is monotone: where every difference is smaller, so is the sum. Hence a lower bound that is computed with
 * this function never exceeds, even by rounding, what it bounds.
 * \param[in] padded number of differences, a multiple of feature_lanes
 * \param[in] limit a sum that exceeds it may be returned before it is complete
 * \param[in] difference function of the feature's number
 */
template <typename Difference>
inline float
sumOfSquares(std::size_t padded, float limit, Difference difference)
{
  constexpr std::size_t between_checks = 4 * feature_lanes;
  float lanes[feature_lanes] = {};
  float sum = 0.0F;
  for (std::size_t begin = 0; begin < padded; begin += between_checks) {
    const std::size_t end = begin + between_checks < padded ? begin + between_checks : padded;
    for (std::size_t i = begin; i < end; i += feature_lanes) {
      for (std::size_t lane = 0; lane < feature_lanes; ++lane) {
        const float d = difference(i + lane);
        lanes[lane] += d * d;
      }
    }
    sum = ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
    if (sum > limit) {
      break;
    }
  }
  return sum;
}

} // namespace symmetry
} // namespace pcl
