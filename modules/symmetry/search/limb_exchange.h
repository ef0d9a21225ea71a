/** \file
 * \brief Maps that differ from a map in where two limbs go.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"
#include "symmetry/search/symmetry_search.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How limbs are exchanged; lengths are shares of the diameter. */
struct LimbExchangeSettings {
  /** Of the ends of limbs. An image within half of it meets an end: one at most, as it is nearer to it than to any other.
   * The whole of it was tried, too, and lost the model (a horse, see the decision) that the exchange was made for. */
  float separation = limb_separation;
  std::size_t exchanges = 6; ///< of a map, at most: all those of four limbs
};

/** \brief Candidates near a few maps: two limbs that stand still, each mirrored in itself, change places, or two that change
 * places stand still.
 *
 * A leg is nearly its own mirror image, so that a map that mirrors both front legs of an animal in themselves, and
 * changes the hind ones, keeps distances about as well as the right one; from few eigenfunctions, which hardly see a
 * raised leg, all hypotheses end there. So the ends of the limbs (extremities) are paired as the map has them, but for
 * two; the map that carries distances to the ends over to those to their partners is refined in all eigenfunctions at once.
 * Of each map those exchanges are tried that change distances least, unless another map pairs the ends like this already.
 * \param[in] maps of the landmarks, the best one first
 * \return each with its score; empty where no two limbs stand still or change places, or fewer than four ends have partners */
std::vector<SymmetryCandidate>
exchangeLimbs(const SampledSurface& sampled,
              const std::vector<SampleMap>& maps,
              const SearchSettings& search,
              const LimbExchangeSettings& settings);

} // namespace symmetry
} // namespace pcl
