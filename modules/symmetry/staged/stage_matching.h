/** \file
 * \brief The matching steps that the stages are made of (paper, section 3.3).
 */
#pragma once

#include "symmetry/staged/base_vertices.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Vertices to be matched and their possible partners. */
struct Matchable {
  std::vector<Index> queries;
  std::vector<Index> candidates; ///< ascending
};

/** \brief The best candidate of every query by the dissimilarity of their feature vectors.
 * \param[in] side side of the queries; the candidates are seen from the other one
 * \return one match per query, oriented from the source to the target side, without midpoints; none where there are no
 * candidates
 */
std::vector<SymmetricMatch>
matchVertices(const BaseVertices& base, const Matchable& vertices, Side side, FeatureSet set);

/** \brief The matches of least cost, at most \a count, cheapest first; of equal ones those of the lower source. */
std::vector<SymmetricMatch>
cheapest(std::vector<SymmetricMatch> matches, std::size_t count);

/** \brief The vertices of a list that lie in a region. */
std::vector<Index>
within(const std::vector<Index>& vertices, const std::vector<Region>& regions, Region region);

/** \brief All vertices of a region, ascending. */
std::vector<Index>
verticesOf(const std::vector<Region>& regions, Region region);

/** \brief Stages 1 and 2: matches the extremities (S1 or S2) of each source limb with those of its target limb and
 * keeps the cheapest \a kept per pair of limbs.
 */
std::vector<SymmetricMatch>
matchExtremities(const BaseVertices& base,
                 const std::vector<Region>& regions,
                 const std::vector<Index>& extremities,
                 std::size_t kept);

/** \brief Stages 3 and 4: matches samples of the source limbs and the centre with all vertices of the target limbs and
 * of the centre's other side, and keeps the cheapest \a kept per mapping.
 *
 * A vertex of the centre is unlike itself only in its side, so its own side is no candidate.
 * \param[in] sides see sideFunction (): positive is the source side
 */
std::vector<SymmetricMatch>
matchSamples(const BaseVertices& base,
             const std::vector<Region>& regions,
             const std::vector<float>& sides,
             const std::vector<Index>& samples,
             FeatureSet set,
             std::size_t kept);

} // namespace symmetry
} // namespace pcl
