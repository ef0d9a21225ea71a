/** \file
 * \brief From a map of the samples to what a method hands on: partners, sides, matches, limbs, other symmetries.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/map_judgement.h"
#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/symmetry_search.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Carries a map of the samples over to all points: partners, sides, confidences, sparse matches, limbs.
 * \param[in,out] estimate with the confidence of the map */
void
deliverMap(const SampledSurface& sampled, const SampleEstimate& samples, MapEstimate& estimate);

/** \brief Fills in matches, limbs and regions of a map of all points whose sides are known.
 * \param[in,out] estimate with partners and side function */
void
describeMap(const SampledSurface& sampled, MapEstimate& estimate);

/** \brief Appends dense maps of the symmetries among the candidates, at most so many, and of the rotations that follow.
 * \param[in] taken the map that was delivered, which comes first
 * \param[in,out] estimate with the delivered map */
void
deliverAlternatives(const SampledSurface& sampled,
                    const SampleRefinement& refinement,
                    const MapJudge& judge,
                    const Contender& taken,
                    const std::vector<SymmetryCandidate>& candidates,
                    const SearchSettings& settings,
                    std::size_t maximum,
                    MapEstimate& estimate);

} // namespace symmetry
} // namespace pcl
