/** \file
 * \brief Candidates from maps that come from elsewhere than the search.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/symmetry_search.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Candidates near given maps of the landmarks, each refined in all eigenfunctions of the search at once: the lower
 * ones alone do not see a single limb, and would lose what a map says of it. Each with its score;
 * empty where the surface is too small for the search. */
std::vector<SymmetryCandidate>
candidatesFromMaps(const SampledSurface& sampled, std::vector<SampleMap> maps, const SearchSettings& settings);

/** \brief Maps of the points of a surface as maps of its landmarks; one that is known of no landmark is left out.
 * \param[in] maps partner of every point, no_index where unknown
 * \return partner of each landmark; where it is unknown that of the nearest landmark of which it is known */
std::vector<SampleMap>
landmarkMapsOf(const SampledSurface& sampled, const std::vector<std::vector<Index>>& maps);

} // namespace symmetry
} // namespace pcl
