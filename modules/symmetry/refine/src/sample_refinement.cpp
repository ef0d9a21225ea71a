#include "symmetry/refine/sample_refinement.h"

#include "base/statistics.h"
#include "symmetry/refine/extremity_rotations.h"
#include "symmetry/refine/map_misfit.h"
#include "symmetry/refine/point_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

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

} // namespace

SampleRefinement::SampleRefinement(const SampledSurface& sampled, const RefinementSettings& settings)
    : sampled_(sampled),
      settings_(settings),
      fitting_(sampled.coarse),
      guide_(describeShape(sampled.coarse, sampled.basis, settings.guide.oriented_dimensions, settings.guide)),
      ends_(sampled.landmarks),
      upward_(sampled.basis.functions,
              guide_,
              static_cast<Eigen::Index>(sampled.coarse.size()),
              settings.levels,
              settings.guidance)
{
  for (const PatchSize& size : settings.patches) {
    alignments_.emplace_back(sampled, size);
  }
}

std::vector<Index>
SampleRefinement::spectralPartners(const SymmetryCandidate& candidate) const
{
  const Eigen::MatrixXf functions = sampled_.basis.functions.leftCols(candidate.matrix.cols());
  SampleMap map = nearestRows(functions * candidate.matrix, functions);
  const Eigen::MatrixXf matrix = upward_.refine(map);
  return partnersOfSamples(sampled_, map, matrix);
}

void
SampleRefinement::rotateExtremitiesOf(std::vector<Index>& partners) const
{
  const std::vector<Index> extremities = extremitiesOf(sampled_.landmarks, settings_.extremity_separation, most_limbs);
  for (const float radius : settings_.extremity_radii) {
    rotateExtremities(sampled_, fitting_, extremities, radius * sampled_.landmarks.diameter, partners);
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
    partners = alignment.align(std::move(partners), settings_.patch_rounds);
    if (!is_roughly_in_place) {
      // The smaller patches then smooth what this tears.
      rotateExtremitiesOf(partners);
      growReflections(sampled_, fitting_, settings_.growth, partners);
      is_roughly_in_place = true;
    }
  }
  partners = mutualPartners(sampled_, std::move(partners), settings_.mutual_rounds);
  for (const Index partner : partners) {
    estimate.map.push_back(sampled_.coarse.cells.owner[partner]);
  }
  estimate.landmark_map = mapOfLandmarks(sampled_.landmarks, estimate.map);
  estimate.score =
      scoreMap(sampled_.landmarks, guide_, estimate.landmark_map, settings_.score_queries, settings_.score);
  estimate.moved_ends = ends_.share(estimate.landmark_map);
  estimate.value = estimate.score.value - settings_.moved_ends * estimate.moved_ends;
  if (!alignments_.empty()) {
    estimate.fits = alignments_.back().fits(partners);
    estimate.fit = meanOf(estimate.fits);
    estimate.worst_distance = worstDistance(estimate.fits);
    estimate.value += settings_.fit * logMisfit(estimate.fits, estimate.fit, settings_.median_turn) -
                      settings_.displacement * estimate.score.log_displacement;
  }
  return estimate;
}

float
SampleRefinement::promise(const SymmetryCandidate& candidate) const
{
  return candidate.score.value - settings_.moved_ends_of_candidates * ends_.share(candidate.map);
}

} // namespace symmetry
} // namespace pcl
