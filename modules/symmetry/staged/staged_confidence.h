/** \file
 * \brief How far the result of the staged method can be trusted.
 */
#pragma once

#include "symmetry/staged/base_vertices.h"
#include "symmetry/staged/dense_map.h"

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A map of lower confidence is none: bodies without two pairs of limbs, or whose four extreme points are no two
 * pairs (the head and the tail of an animal), end below. */
constexpr float minimum_trusted_confidence = 0.2F;

/** \brief Mean difference of distances that a symmetry leaves alike, share of the diameter.
 *
 * For matches (s, t) and (s', t'): |d(s, s') - d(t, t')| and |d(s, t') - d(t, s')|.
 * \param[in] base base vertices made of the matches
 * \param[in] matches in the order in which they were added
 */
float
isometricDistortion(const BaseVertices& base, const std::vector<SymmetricMatch>& matches, float diameter);

/** \brief Share of the matched vertices whose partner's partner is within 2 % of the diameter, measured straight
 * through space: a lower bound of the distance on the surface that costs no shortest paths. */
float
involutionShare(const std::vector<Vector3>& points, const std::vector<Index>& partners, float diameter);

/** \brief Confidence that follows from the distortion: exp (-(distortion / 5 %)^2).
 *
 * Poses distort distances by 2 to 4 %; a wrong map, even a good partial one, by 10 % and more. The confidence of a map
 * is this times its involutionShare (), if it is dense.
 */
float
distortionConfidence(float distortion);

/** \brief What the extreme pairs add to it, a factor: exp (-(cost / 0.8)^4), near 1 unless a limb is missing.
 * \param[in] cost see ExtremePairs */
float
pairsConfidence(float cost);

/** \brief Confidence per vertex in [0, 1]: that of the map, less where the features of the partners differ (root mean
 * square 15 % off: a factor of 1 / e) and where the partner's partner is far (10 % of the diameter: 1 / e). */
std::vector<float>
vertexConfidences(const std::vector<Vector3>& points,
                  const DenseMap& map,
                  std::size_t features,
                  float diameter,
                  float map_confidence);

} // namespace symmetry
} // namespace pcl
