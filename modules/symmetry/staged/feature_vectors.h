/** \file
 * \brief Feature vectors of vertices and their dissimilarity (paper, section 3.3).
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Row-major matrix: row i is the feature vector of vertex (or candidate) i. Features are finite and not
 * negative: geodesic distances to base vertices. */
struct FeatureVectors {
  std::size_t dimensions = 0;
  std::vector<float> values;

  const float*
  row(std::size_t i) const
  {
    return values.data() + i * dimensions;
  }

  std::size_t
  rows() const
  {
    return dimensions == 0 ? 0 : values.size() / dimensions;
  }
};

/** \brief A candidate and how unlike the query it is. */
struct FeatureMatch {
  std::ptrdiff_t row = -1; ///< of the candidates; -1 where there are none
  float dissimilarity = 0.0F;
};

/** \brief Share of a feature's maximum below which it no longer gains weight.
 *
 * The dissimilarity divides by the feature itself, so that near distances count more; without a floor a vertex beside a
 * base vertex would be judged by nothing else, and the base vertex itself could not be judged at all.
 */
constexpr float feature_floor_share = 0.02F;

/** \brief Weight of a feature: 1 / max (value, floor), 0 where both are zero. */
inline float
featureWeight(float value, float floor)
{
  const float divisor = std::max(value, floor);
  return divisor > 0.0F ? 1.0F / divisor : 0.0F;
}

/** \brief Floor of each feature: feature_floor_share of its maximum over all rows. */
std::vector<float>
featureFloors(const FeatureVectors& features);

/** \brief D = sum over i of ((rho_i - rho'_i) / rho_i)^2, rho_i of the query bounded from below by its floor.
 *
 * Terms are added in interleaved sums, in the order DenseMatcher uses: the two agree to the last bit.
 */
float
dissimilarity(const float* query, const float* candidate, const std::vector<float>& floors);

} // namespace symmetry
} // namespace pcl
