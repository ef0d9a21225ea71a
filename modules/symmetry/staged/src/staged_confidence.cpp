#include "symmetry/staged/staged_confidence.h"

#include "base/vector_math.h"
#include "symmetry/staged/staged_settings.h"

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr StagedConfidenceSettings settings{};

} // namespace

float
isometricDistortion(const BaseVertices& base, const std::vector<SymmetricMatch>& matches, float diameter)
{
  double sum = 0.0;
  std::size_t terms = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const float* from_source = base.sourceFields().row(i);
    const float* from_target = base.targetFields().row(i);
    for (std::size_t j = 0; j < matches.size(); ++j) {
      sum += std::abs(from_source[matches[j].source] - from_target[matches[j].target]);
      sum += std::abs(from_source[matches[j].target] - from_target[matches[j].source]);
      terms += 2;
    }
  }
  return terms == 0 ? 0.0F : static_cast<float>(sum / static_cast<double>(terms)) / diameter;
}

float
involutionShare(const std::vector<Vector3>& points, const std::vector<Index>& partners, float diameter)
{
  std::size_t matched = 0;
  std::size_t returned = 0;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    if (partners[v] != no_index && partners[partners[v]] != no_index) {
      ++matched;
      returned += distance(points[v], points[partners[partners[v]]]) < settings.involution_tolerance * diameter ? 1 : 0;
    }
  }
  return matched == 0 ? 0.0F : static_cast<float>(returned) / static_cast<float>(matched);
}

float
distortionConfidence(float distortion)
{
  const float relative = distortion / settings.tolerable_distortion;
  return std::exp(-relative * relative);
}

float
pairsConfidence(float cost)
{
  const float relative = cost / settings.tolerable_pairs;
  return std::exp(-relative * relative * relative * relative);
}

std::vector<float>
vertexConfidences(
    const std::vector<Vector3>& points, const DenseMap& map, std::size_t features, float diameter, float map_confidence)
{
  std::vector<float> confidences(map.partners.size(), 0.0F);
  for (std::size_t v = 0; v < confidences.size(); ++v) {
    const Index partner = map.partners[v];
    if (partner == no_index || map.partners[partner] == no_index) {
      continue;
    }
    const float off = std::sqrt(map.dissimilarities[v] / static_cast<float>(features));
    const float back = distance(points[v], points[map.partners[partner]]) / diameter;
    confidences[v] = map_confidence * std::exp(-off / settings.feature_scale - back / settings.return_scale);
  }
  return confidences;
}

} // namespace symmetry
} // namespace pcl
