#include "symmetry/refine/sample_refinement.h"

#include "base/statistics.h"
#include "symmetry/refine/extremity_rotations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

ShapeDescriptor
describeGuide(const CoarseSurface& coarse, const LaplacianBasis& basis, int dimensions)
{
  DescriptorWeights weights;
  weights.oriented_dimensions = dimensions;
  return describeShape(coarse, basis, dimensions, weights);
}

/** The image of every landmark among the landmarks. */
SampleMap
mapOfLandmarks(const LandmarkSurface& landmarks, const SampleMap& map)
{
  SampleMap among_landmarks;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    among_landmarks.push_back(landmarks.nearest_landmark[map[i]]);
  }
  return among_landmarks;
}

PatchFit
meanOf(const std::vector<PatchFit>& fits)
{
  PatchFit mean{0.0F, 0.0F};
  for (const PatchFit& fit : fits) {
    mean.distance += fit.distance / static_cast<float>(fits.size());
    mean.turn += fit.turn / static_cast<float>(fits.size());
  }
  return mean;
}

float
worstDistance(const std::vector<PatchFit>& fits)
{
  constexpr double most = 0.98;
  std::vector<float> distances(fits.size());
  std::transform(fits.begin(), fits.end(), distances.begin(), [](const PatchFit& fit) { return fit.distance; });
  return quantile(std::move(distances), most);
}

/** Logarithm of the misfit of the patches. Normals tell more than distances: on a smooth body a wrong patch lies close
 * as well, but does not face the right way. */
float
logMisfit(const PatchFit& fit)
{
  constexpr float least_distance = 2e-3F; // sampling noise
  constexpr float least_turn = 0.01F;
  return 0.5F * std::log(fit.distance + least_distance) + std::log(fit.turn + least_turn);
}

} // namespace

SampleRefinement::SampleRefinement(const PreparedSurface& surface,
                                   const CoarseSurface& coarse,
                                   const LaplacianBasis& basis,
                                   const LandmarkSurface& landmarks,
                                   const SampleInterpolation& interpolation,
                                   const CellMembers& members,
                                   const RefinementSettings& settings,
                                   unsigned threads)
    : surface_(surface),
      coarse_(coarse),
      basis_(basis),
      landmarks_(landmarks),
      interpolation_(interpolation),
      members_(members),
      probes_(thinnedMembers(members, settings.probes)),
      settings_(settings),
      threads_(threads),
      fitting_(coarse),
      guide_(describeGuide(coarse, basis, settings.guide_dimensions)),
      upward_(basis.functions, guide_, static_cast<Eigen::Index>(coarse.size()), settings.levels, settings.guidance)
{
  for (const PatchSize& size : settings.patches) {
    alignments_.emplace_back(surface, coarse, probes_, landmarks.diameter, size, threads);
  }
}

std::vector<Index>
SampleRefinement::spectralPartners(const SymmetryCandidate& candidate) const
{
  const Eigen::MatrixXf functions = basis_.functions.leftCols(candidate.matrix.cols());
  SampleMap map = nearestRows(functions * candidate.matrix, functions, threads_);
  const Eigen::MatrixXf matrix = upward_.refine(map, threads_);
  return partnersOfSamples(coarse_, basis_, interpolation_, members_, map, matrix, threads_);
}

void
SampleRefinement::turnEnds(std::vector<Index>& partners) const
{
  constexpr std::size_t most = 16;
  const std::vector<Index> tips = extremitiesOf(landmarks_, settings_.end_separation, most);
  for (const float radius : settings_.end_radii) {
    turnParts(surface_, coarse_, fitting_, tips, radius * landmarks_.diameter, partners, threads_);
  }
}

SampleEstimate
SampleRefinement::refine(const SymmetryCandidate& candidate) const
{
  SampleEstimate estimate;
  std::vector<Index>& partners = estimate.partners;
  partners = spectralPartners(candidate);
  bool is_roughly_in_place = false;
  for (const PatchAlignment& alignment : alignments_) {
    partners = alignment.align(std::move(partners), settings_.patch_rounds, threads_);
    if (!is_roughly_in_place) {
      // The smaller patches then smooth what this tears.
      turnEnds(partners);
      growReflections(surface_, coarse_, fitting_, landmarks_.diameter, settings_.growth, partners, threads_);
      is_roughly_in_place = true;
    }
  }
  partners = mutualPartners(surface_, coarse_, probes_, std::move(partners), settings_.mutual_rounds, threads_);
  for (const Index partner : partners) {
    estimate.map.push_back(coarse_.cells.owner[partner]);
  }
  estimate.landmark_map = mapOfLandmarks(landmarks_, estimate.map);
  estimate.score = scoreMap(landmarks_, guide_, estimate.landmark_map, settings_.score_queries, settings_.score);
  estimate.value = estimate.score.value;
  if (!alignments_.empty()) {
    const std::vector<PatchFit> fits = alignments_.back().fits(partners, threads_);
    estimate.fit = meanOf(fits);
    estimate.worst_distance = worstDistance(fits);
    estimate.value += settings_.fit * logMisfit(estimate.fit);
  }
  return estimate;
}

} // namespace symmetry
} // namespace pcl
