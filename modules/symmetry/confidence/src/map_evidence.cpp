#include "symmetry/confidence/map_evidence.h"

#include "base/statistics.h"
#include "symmetry/confidence/local_change.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** The landmarks as if holes were where there is no support, and average distances those to the rest alone. */
LandmarkSurface
supportedLandmarks(const LandmarkSurface& landmarks, const Support& support)
{
  LandmarkSurface supported = landmarks;
  Eigen::VectorXf counts(static_cast<Eigen::Index>(landmarks.size()));
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const bool is_supported = support.is_disturbed[i] == 0;
    supported.at_hole[i] = static_cast<char>(landmarks.at_hole[i] != 0 || !is_supported);
    counts[static_cast<Eigen::Index>(i)] = is_supported ? 1.0F : 0.0F;
  }
  const Eigen::VectorXf mean = landmarks.distances * counts / std::max(1.0F, counts.sum());
  supported.average_distance.assign(mean.data(), mean.data() + mean.size());
  return supported;
}

/** The shares of MapScore that stand still and that are distorted, of the supported landmarks. */
void
measureSupported(const LandmarkSurface& landmarks, const SampleMap& map, const Support& support, MapScore& score)
{
  constexpr float stands_still = 0.06F; // as MapScore::fixed
  constexpr float much = 0.08F;         // as MapScore::distorted
  std::vector<Index> supported;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (support.is_disturbed[i] == 0) {
      supported.push_back(static_cast<Index>(i));
    }
  }
  std::size_t fixed = 0;
  std::size_t distorted = 0;
  for (const Index i : supported) {
    float change = 0.0F;
    for (const Index j : supported) {
      change += std::abs(landmarks.distances(j, i) - landmarks.distances(map[j], map[i]));
    }
    distorted += change > much * landmarks.diameter * static_cast<float>(supported.size()) ? 1U : 0U;
    fixed += landmarks.distances(i, map[i]) < stands_still * landmarks.diameter ? 1U : 0U;
  }
  const auto count = static_cast<float>(std::max<std::size_t>(1, supported.size()));
  score.fixed = static_cast<float>(fixed) / count;
  score.distorted = static_cast<float>(distorted) / count;
}

} // namespace

PointSpacing
measureSpacing(const SurfaceGraph& graph, const std::vector<Index>& samples, float diameter)
{
  constexpr double nearly_all = 0.9;
  std::vector<float> means;
  std::vector<float> ratios;
  for (const Index v : samples) {
    const auto begin = graph.lengths.begin() + graph.offsets[v];
    const auto end = graph.lengths.begin() + graph.offsets[v + 1];
    const float nearest = begin != end ? *std::min_element(begin, end) : 0.0F;
    if (nearest > 0.0F) { // and not too small for a float
      means.push_back(std::accumulate(begin, end, 0.0F) / static_cast<float>(end - begin));
      ratios.push_back(means.back() / nearest);
    }
  }
  if (means.empty()) {
    return {};
  }
  return {quantile(std::move(means), nearly_all) / diameter, median(std::move(ratios))};
}

float
shareAtHoles(const CoarseSurface& coarse)
{
  return static_cast<float>(std::count(coarse.at_hole.begin(), coarse.at_hole.end(), 1)) /
         static_cast<float>(coarse.size());
}

MapEvidence
gatherEvidence(const SampledSurface& sampled,
               const SymmetryCandidate& candidate,
               const SampleEstimate& samples,
               const PointSpacing& spacing)
{
  constexpr double worst_places = 0.97;
  MapEvidence evidence;
  evidence.score = samples.score;
  evidence.rough_curvature = candidate.score.curvature;
  evidence.measures = findAsymmetry(sampled.landmarks, sampled.descriptor.curvature, samples.landmark_map);
  evidence.fit = samples.fit;
  evidence.worst_distance = samples.worst_distance;
  evidence.is_noisy = sampled.surface.summary.smoothing_radius > 0.0F;
  evidence.at_holes = shareAtHoles(sampled.coarse);
  evidence.spacing = spacing;
  evidence.local_changes = LocalDistanceChange(sampled, samples.partners).everywhere();
  evidence.local_change = median(evidence.local_changes);
  evidence.worst_local_change = quantile(evidence.local_changes, worst_places);
  std::vector<float> turns;
  for (const PatchFit& fit : samples.fits) {
    turns.push_back(fit.turn);
  }
  evidence.turn = median(turns);
  evidence.worst_turn = quantile(turns, worst_places);
  return evidence;
}

MapEvidence
gatherSupportedEvidence(const SampledSurface& sampled,
                        const SymmetryCandidate& candidate,
                        const SampleEstimate& samples,
                        const Support& support,
                        const MapEvidence& whole)
{
  MapEvidence evidence = whole;
  const LandmarkSurface supported = supportedLandmarks(sampled.landmarks, support);
  evidence.measures = findAsymmetry(supported, sampled.descriptor.curvature, samples.landmark_map);
  evidence.rough_curvature =
      scoreMap(supported, sampled.descriptor, candidate.map, candidate.map.size(), ScoreWeights{}).curvature;
  measureSupported(sampled.landmarks, samples.landmark_map, support, evidence.score);
  std::vector<PatchFit> fits;
  for (std::size_t k = 0; k < samples.fits.size(); ++k) {
    if (support.is_disturbed[k] == 0) {
      fits.push_back(samples.fits[k]);
    }
  }
  evidence.fit = meanOf(fits);
  evidence.worst_distance = worstDistance(fits);
  return evidence;
}

std::vector<std::pair<std::string, float>>
namedMeasures(const MapEvidence& evidence)
{
  return {{"score", evidence.score.value},
          {"isometry", evidence.score.isometry},
          {"involution", evidence.score.involution},
          {"displacement", evidence.score.displacement},
          {"log_displacement", evidence.score.log_displacement},
          {"nearest_image", evidence.score.nearest_image},
          {"fixed", evidence.score.fixed},
          {"reversal", evidence.score.reversal},
          {"curvature", evidence.score.curvature},
          {"distorted", evidence.score.distorted},
          {"rough_curvature", evidence.rough_curvature},
          {"concentration", evidence.measures.concentration},
          {"stretch", evidence.measures.stretch},
          {"relaxed_involution", evidence.measures.involution},
          {"average_distance", evidence.measures.average_distance},
          {"local_curvature", evidence.measures.curvature},
          {"fit_distance", evidence.fit.distance},
          {"fit_turn", evidence.fit.turn},
          {"worst_distance", evidence.worst_distance},
          {"noisy", evidence.is_noisy ? 1.0F : 0.0F},
          {"at_holes", evidence.at_holes},
          {"sparse", evidence.spacing.sparse},
          {"irregularity", evidence.spacing.irregularity},
          {"local_change", evidence.local_change},
          {"worst_local_change", evidence.worst_local_change},
          {"turn", evidence.turn},
          {"worst_turn", evidence.worst_turn}};
}

} // namespace symmetry
} // namespace pcl
