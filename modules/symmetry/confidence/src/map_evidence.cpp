#include "symmetry/confidence/map_evidence.h"

#include "base/statistics.h"
#include "symmetry/confidence/local_change.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {

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
  const std::vector<float> change = localDistanceChange(sampled, samples.partners);
  evidence.local_change = median(change);
  evidence.worst_local_change = quantile(change, worst_places);
  std::vector<float> turns;
  for (const PatchFit& fit : samples.fits) {
    turns.push_back(fit.turn);
  }
  evidence.turn = median(turns);
  evidence.worst_turn = quantile(turns, worst_places);
  return evidence;
}

std::vector<std::pair<std::string, float>>
namedMeasures(const MapEvidence& evidence)
{
  return {{"score", evidence.score.value},
          {"isometry", evidence.score.isometry},
          {"involution", evidence.score.involution},
          {"displacement", evidence.score.displacement},
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
