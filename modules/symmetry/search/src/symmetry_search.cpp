#include "symmetry/search/symmetry_search.h"

#include "base/parallel.h"
#include "symmetry/search/map_regrowth.h"

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
keepDistinct(std::vector<SymmetryCandidate> candidates,
             const LandmarkSurface& landmarks,
             float distinct,
             std::size_t maximum)
{
  std::vector<SymmetryCandidate> kept;
  for (SymmetryCandidate& candidate : candidates) {
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const SymmetryCandidate& other) {
      return mapDifference(landmarks, candidate.map, other.map) >= distinct;
    });
    if (is_new && kept.size() < maximum) {
      kept.push_back(std::move(candidate));
    }
  }
  return kept;
}

/** Matches a few landmarks under every hypothesis and scores the maps. */
std::vector<SymmetryCandidate>
tryHypotheses(const SampledSurface& sampled,
              const std::vector<SymmetryHypothesis>& hypotheses,
              const SearchSettings& settings)
{
  const ShapeDescriptor& descriptor = sampled.descriptor;
  const LandmarkSurface& landmarks = sampled.landmarks;
  const auto queries = static_cast<Eigen::Index>(std::min(settings.coarse_queries, landmarks.size()));
  const auto targets = static_cast<Eigen::Index>(std::min(settings.coarse_targets, landmarks.size()));
  const RowSearch search(descriptor.joined(targets));
  ScoreWeights weights = settings.score;
  weights.resolution = settings.coarse_resolution;
  std::vector<SymmetryCandidate> candidates(hypotheses.size());
  parallelFor(hypotheses.size(), [&](std::size_t i) {
    SymmetryCandidate& candidate = candidates[i];
    candidate.matrix = hypotheses[i].action;
    candidate.map = search.nearest(descriptor.mirrored(hypotheses[i].action, queries));
    candidate.score = scoreMap(landmarks, descriptor, candidate.map, candidate.map.size(), weights);
  });
  return candidates;
}

/** Brings candidates up through the eigenfunctions; what it needs to do so is prepared once. */
class CandidateRefinement {
public:
  CandidateRefinement(const SampledSurface& sampled, const SearchSettings& settings)
      : descriptor_(sampled.descriptor),
        landmarks_(sampled.landmarks),
        settings_(settings),
        guide_(describeShape(sampled.coarse, sampled.basis, settings.guide.oriented_dimensions, settings.guide)),
        targets_(sampled.descriptor.joined(count())),
        refinement_(sampled.basis.functions, guide_, count(), settings.levels, settings.guidance),
        last_step_(sampled.basis.functions, guide_, count(), {settings.levels.back()}, settings.guidance)
  {
  }

  /** From the action of a hypothesis. */
  void
  refine(SymmetryCandidate& candidate) const
  {
    candidate.map = targets_.nearest(descriptor_.mirrored(candidate.matrix, count()));
    finish(candidate);
  }

  /** Derives the whole map anew from the part of it that is surely a reflection: from the distances to the landmarks
   * that move far and come back. Turns a partial reflection (one pair of limbs swapped, the rest standing still) into a
   * whole one. */
  SymmetryCandidate
  rederived(const SymmetryCandidate& candidate) const
  {
    const std::vector<Index> anchors = reflectedLandmarks(candidate.map);
    Eigen::MatrixXf from(count(), static_cast<Eigen::Index>(anchors.size()));
    Eigen::MatrixXf to(from.rows(), from.cols());
    for (std::size_t k = 0; k < anchors.size(); ++k) {
      from.col(static_cast<Eigen::Index>(k)) = landmarks_.distances.col(anchors[k]);
      to.col(static_cast<Eigen::Index>(k)) = landmarks_.distances.col(candidate.map[anchors[k]]);
    }
    SymmetryCandidate result;
    result.map = nearestRows(from, to);
    finish(result);
    return result;
  }

  /** Derives anew what the map does not turn over. Only the last step of the refinement follows: the lower ones do not
   * see the parts that this is about. */
  void
  regrow(SymmetryCandidate& candidate) const
  {
    SymmetryCandidate regrown;
    regrown.map = regrownMap(landmarks_, candidate.map);
    if (regrown.map.empty()) {
      return;
    }
    regrown.matrix = last_step_.refine(regrown.map);
    regrown.score = scoreMap(landmarks_, descriptor_, regrown.map, settings_.coarse_targets, settings_.score);
    if (regrown.score.value < candidate.score.value) {
      candidate = std::move(regrown);
    }
  }

private:
  Eigen::Index
  count() const
  {
    return static_cast<Eigen::Index>(landmarks_.size());
  }

  void
  finish(SymmetryCandidate& candidate) const
  {
    candidate.matrix = refinement_.refine(candidate.map);
    candidate.score = scoreMap(landmarks_, descriptor_, candidate.map, settings_.coarse_targets, settings_.score);
  }

  std::vector<Index>
  reflectedLandmarks(const SampleMap& map) const
  {
    constexpr float far = 0.15F; // share of the diameter, chosen by hand: clearly moved
    constexpr std::size_t maximum_anchors = 60;
    std::vector<Index> anchors;
    for (std::size_t i = 0; i < map.size() && anchors.size() < maximum_anchors; ++i) {
      if (isExchanged(landmarks_, map, static_cast<Index>(i), far)) {
        anchors.push_back(static_cast<Index>(i));
      }
    }
    return anchors;
  }

  const ShapeDescriptor& descriptor_;
  const LandmarkSurface& landmarks_;
  const SearchSettings& settings_;
  ShapeDescriptor guide_;
  RowSearch targets_;
  UpwardRefinement refinement_;
  UpwardRefinement last_step_;
};

std::vector<SymmetryHypothesis>
makeHypotheses(const LandmarkSurface& landmarks,
               const LaplacianBasis& basis,
               int dimensions,
               const SearchSettings& settings)
{
  std::vector<SymmetryHypothesis> hypotheses;
  if (settings.sign_patterns) {
    hypotheses = signPatternHypotheses(dimensions);
  }
  if (settings.pairings > 0) {
    const std::vector<SymmetryHypothesis> more = extremityHypotheses(landmarks, basis, dimensions, settings.pairings);
    hypotheses.insert(hypotheses.end(), more.begin(), more.end());
  }
  return hypotheses;
}

} // namespace

std::vector<SymmetryCandidate>
searchSymmetries(const SampledSurface& sampled, const SearchSettings& settings)
{
  if (!sampled.isSearchable()) {
    return {};
  }
  const LandmarkSurface& landmarks = sampled.landmarks;
  const auto dimensions = static_cast<int>(sampled.descriptor.spectral.cols());
  std::vector<SymmetryCandidate> candidates =
      tryHypotheses(sampled, makeHypotheses(landmarks, sampled.basis, dimensions, settings), settings);
  sortByScore(candidates);
  candidates = keepDistinct(std::move(candidates), landmarks, settings.distinct, settings.refined);

  const CandidateRefinement refinement(sampled, settings);
  parallelFor(candidates.size(), [&](std::size_t i) { refinement.refine(candidates[i]); });
  sortByScore(candidates);
  candidates = keepDistinct(std::move(candidates), landmarks, settings.distinct, settings.refined);

  const std::size_t rederived = std::min(settings.rederived, candidates.size());
  candidates.resize(candidates.size() + rederived);
  parallelFor(rederived, [&](std::size_t i) {
    candidates[candidates.size() - rederived + i] = refinement.rederived(candidates[i]);
  });
  sortByScore(candidates);
  parallelFor(std::min(settings.regrown, candidates.size()), [&](std::size_t i) { refinement.regrow(candidates[i]); });
  sortByScore(candidates);
  return keepDistinct(std::move(candidates), landmarks, settings.distinct, settings.refined);
}

} // namespace symmetry
} // namespace pcl
