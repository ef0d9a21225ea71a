/** \file
 * \brief Which of the points that stick out are the two pairs of limbs that the staged method begins with (paper,
 * section 3.1).
 */
#pragma once

#include "geodesic/surface_metric.h"
#include "symmetry/staged/extremities.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Two pairs of partners: h1 and f1 on the source side, h2 and f2 on the target side (the paper's E). */
struct ExtremePairs {
  Index h1 = no_index;
  Index h2 = no_index;
  Index f1 = no_index;
  Index f2 = no_index;
  /** How much chooseExtremePairs () finds changed, in the measure that it minimises; about 0.2 on bodies, 0.5 where
   * a limb is missing. */
  float cost = 0.0F;
};

/** \brief Pairs four extreme points.
 *
 * As published, the two smallest in the feature are partners and so are the two largest. Where that is not clear (the
 * step between the pairs is smaller than one within a pair or than 5 % of the feature) those are partners whose
 * distances to the landmarks are distributed alike: AGD is the mean of this distribution, and different ones may have
 * the same mean.
 *
 * Which of the second pair lies on the side of h1 is decided by the distances on the surface: the paper compares
 * d(h1, f1) with d(h1, f2); here the sums over both sides are compared, which differ by more when one limb is bent.
 * \param[in] points four distinct vertices
 * \param[in] feature per vertex: AGD or MGD
 * \param[in] metric of the surface itself
 * \param[in] landmarks evenly spaced vertices
 */
ExtremePairs
pairExtremePoints(const std::array<Index, 4>& points,
                  const std::vector<float>& feature,
                  const SurfaceMetric& metric,
                  const std::vector<Index>& landmarks);

/** \brief Chooses two pairs of partners among extreme points, of which some are none.
 *
 * The paper's four points are the tips of hands and feet. On an animal the first four are its head, its tail and two
 * paws; all paws are among the first nine. Head and tail have no partner: a reflection leaves them where they are. So of
 * all ways to make two pairs of these points that one is taken which changes least
 * - the distances of the partners to the landmarks, as pairExtremePoints () compares them,
 * - the distances between the pairs,
 * - the distances of the foremost other points to all four, where a point may be its own image or another one's.
 *
 * The sum of the three, and what a pose adds to it, is taken relative to the least distance of two of the four:
 * neighbours on one limb are alike whatever the surface.
 * \param[in] points at least four distinct vertices, the foremost first
 * \param[in] feature per vertex: AGD or MGD; as with pairExtremePoints () h1 is the point where it is least
 * \param[in] metric of the surface itself
 * \param[in] landmarks evenly spaced vertices
 * \return sides as with pairExtremePoints (). Cost: one distance field per point
 */
ExtremePairs
chooseExtremePairs(const std::vector<Index>& points,
                   const std::vector<float>& feature,
                   const SurfaceMetric& metric,
                   const std::vector<Index>& landmarks);

/** \brief The function that the parameters choose for pairing. */
const std::vector<float>&
pairingFeature(const ExtremityFunctions& functions, PairingFeature feature);

} // namespace symmetry
} // namespace pcl
