/** \file
 * \brief Which of several refined maps is taken, and whether it is a symmetry at all.
 */
#pragma once

#include "symmetry/confidence/map_confidence.h"
#include "symmetry/map_estimate.h"
#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/symmetry_search.h"

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A candidate and what became of it. */
struct Contender {
  const SymmetryCandidate* candidate = nullptr;
  SampleEstimate samples;
};

/** \brief The candidates that promise most, see SampleRefinement::promise (), the best one first.
 * \param[in] candidates referred to, not copied
 * \param[in] maximum at most so many
 * \param[in] margin none that promises less than the best one by more */
std::vector<const SymmetryCandidate*>
closestCandidates(const SampleRefinement& refinement,
                  const std::vector<SymmetryCandidate>& candidates,
                  std::size_t maximum,
                  float margin);

/** \brief Refines candidates and puts them among the contenders; what fits best comes first.
 * \param[in] candidates referred to, not copied */
void
addContenders(const SampleRefinement& refinement,
              const std::vector<const SymmetryCandidate*>& candidates,
              std::vector<Contender>& contenders);

/** \brief Judges maps of one surface. */
class MapJudge {
public:
  /** \param[in] sampled referred to, not copied */
  explicit MapJudge(const SampledSurface& sampled);

  /** \brief Status, message and confidence of the map that is taken, which comes to the front.
   *
   * Of a mesh the one that fits best; of a cloud, whose contacts may be misread, the best one that is trusted, see
   * bestTrustedMap (). */
  MapEstimate
  verdict(std::vector<Contender>& contenders) const;

  /** \brief What speaks for and against a map. */
  MapEvidence
  evidenceFor(const SymmetryCandidate& candidate, const SampleEstimate& samples) const
  {
    return gatherEvidence(sampled_, candidate, samples, spacing_);
  }

private:
  /** The parts without a counterpart, and what is left. */
  struct JudgedSupport {
    Support support;
    std::vector<float> changes; ///< local changes, see takeBackSupported ()
    float confidence = 0.0F;    ///< of the map of the rest

    /** How far the map of the rest can be trusted: less the less is left. */
    float
    trust() const
    {
      return confidence * (1.0F - support.unsupported_share);
    }

    bool
    outweighs(float of_whole) const;
  };

  float
  chooseContender(std::vector<Contender>& contenders, MapEvidence& evidence) const;

  JudgedSupport
  judgeRest(const Contender& contender,
            const MapEvidence& evidence,
            float confidence,
            const SupportSettings& settings) const;

  std::optional<JudgedSupport>
  lookCloser(const Contender& contender, const MapEvidence& evidence, float confidence) const;

  void
  judgeSupport(const Contender& contender, const MapEvidence& evidence, float confidence, MapEstimate& estimate) const;

  float
  knownHoles() const;

  const SampledSurface& sampled_;
  PointSpacing spacing_; ///< of a cloud
};

} // namespace symmetry
} // namespace pcl
