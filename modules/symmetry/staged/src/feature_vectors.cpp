#include "symmetry/staged/feature_vectors.h"

#include "symmetry/staged/feature_kernels.h"

namespace pcl {
namespace symmetry {

std::vector<float>
featureFloors(const FeatureVectors& features)
{
  std::vector<float> floors(features.dimensions, 0.0F);
  for (std::size_t row = 0; row < features.rows(); ++row) {
    for (std::size_t i = 0; i < features.dimensions; ++i) {
      floors[i] = std::max(floors[i], features.row(row)[i]);
    }
  }
  for (float& floor : floors) {
    floor *= feature_floor_share;
  }
  return floors;
}

float
dissimilarity(const float* query, const float* candidate, const std::vector<float>& floors)
{
  const std::size_t dimensions = floors.size();
  const std::size_t padded = (dimensions + feature_lanes - 1) / feature_lanes * feature_lanes;
  return sumOfSquares(padded, [&](std::size_t i) {
    return i < dimensions ? (query[i] - candidate[i]) * featureWeight(query[i], floors[i]) : 0.0F;
  });
}

} // namespace symmetry
} // namespace pcl
