#include "symmetry/symmetry_search.h"

#include "geodesic/parallel.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

void
sortByScore(std::vector<SymmetryCandidate>& candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(), [](const SymmetryCandidate& a, const SymmetryCandidate& b) {
    return a.score.value < b.score.value;
  });
}

/** Of candidates sorted by score, the first of each group of nearly equal maps. */
std::vector<SymmetryCandidate>
keepDistinct(std::vector<SymmetryCandidate> candidates, const HubSurface& hubs, float distinct, std::size_t most)
{
  std::vector<SymmetryCandidate> kept;
  for (SymmetryCandidate& candidate : candidates) {
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const SymmetryCandidate& other) {
      return mapDifference(hubs, candidate.map, other.map) >= distinct;
    });
    if (is_new && kept.size() < most) {
      kept.push_back(std::move(candidate));
    }
  }
  return kept;
}

/** Matches a few hubs under every hypothesis and scores the maps. */
std::vector<SymmetryCandidate>
tryHypotheses(const std::vector<SymmetryHypothesis>& hypotheses,
              const ShapeDescriptor& descriptor,
              const HubSurface& hubs,
              const SearchSettings& settings,
              unsigned threads)
{
  const auto queries = static_cast<Eigen::Index>(std::min(settings.coarse_queries, hubs.size()));
  const auto targets = static_cast<Eigen::Index>(std::min(settings.coarse_targets, hubs.size()));
  const Eigen::MatrixXf all = descriptor.joined(targets);
  std::vector<SymmetryCandidate> candidates(hypotheses.size());
  parallelFor(hypotheses.size(), threads, [&](std::size_t i) {
    SymmetryCandidate& candidate = candidates[i];
    candidate.source = hypotheses[i].source;
    candidate.matrix = hypotheses[i].action;
    candidate.map = nearestRows(descriptor.mirrored(hypotheses[i].action, queries), all);
    candidate.score = scoreMap(hubs, candidate.map, candidate.map.size(), settings.score);
  });
  return candidates;
}

void
refineCandidates(std::vector<SymmetryCandidate>& candidates,
                 const CoarseSurface& surface,
                 const ShapeDescriptor& descriptor,
                 const LaplacianBasis& basis,
                 const HubSurface& hubs,
                 const SearchSettings& settings,
                 unsigned threads)
{
  const auto count = static_cast<Eigen::Index>(hubs.size());
  const Eigen::MatrixXf all = descriptor.joined(count);
  DescriptorWeights guide_weights = settings.descriptor;
  guide_weights.oriented_dimensions = settings.guide_dimensions;
  const ShapeDescriptor guide = describeShape(surface, basis, settings.guide_dimensions, guide_weights);
  const UpwardRefinement refinement(basis.functions, guide, count, settings.levels, settings.guidance);
  parallelFor(candidates.size(), threads, [&](std::size_t i) {
    SymmetryCandidate& candidate = candidates[i];
    candidate.map = nearestRows(descriptor.mirrored(candidate.matrix, count), all);
    candidate.matrix = refinement.refine(candidate.map);
    candidate.score = scoreMap(hubs, candidate.map, settings.coarse_targets, settings.score);
  });
}

} // namespace

std::vector<SymmetryCandidate>
searchSymmetries(const CoarseSurface& surface,
                 const LaplacianBasis& basis,
                 const HubSurface& hubs,
                 const SearchSettings& settings,
                 unsigned threads)
{
  const ShapeDescriptor descriptor = describeShape(surface, basis, settings.dimensions, settings.descriptor);
  const auto dimensions = static_cast<int>(descriptor.spectral.cols());
  std::vector<SymmetryHypothesis> hypotheses;
  if (settings.sign_patterns) {
    hypotheses = signPatternHypotheses(dimensions);
  }
  if (settings.pairings > 0) {
    const std::vector<SymmetryHypothesis> more = extremityHypotheses(hubs, basis, dimensions, settings.pairings);
    hypotheses.insert(hypotheses.end(), more.begin(), more.end());
  }

  std::vector<SymmetryCandidate> candidates = tryHypotheses(hypotheses, descriptor, hubs, settings, threads);
  sortByScore(candidates);
  candidates = keepDistinct(std::move(candidates), hubs, settings.distinct, settings.refined);
  refineCandidates(candidates, surface, descriptor, basis, hubs, settings, threads);
  sortByScore(candidates);
  return keepDistinct(std::move(candidates), hubs, settings.distinct, settings.refined);
}

} // namespace symmetry
} // namespace pcl
