/** \file
 * \brief Takes the symmetry of a body away: cuts off one of its limbs.
 */
#pragma once

#include "benchmark/disturbance.h"
#include "benchmark/ground_truth.h"

namespace pcl {
namespace symmetry {

/** \brief Which limbs are cut off. */
enum class Limb : char {
  Farthest, ///< the one that ends at the landmark farthest from its partner: an arm, a hind leg
  Other     ///< one that ends far from that one and from its counterpart: a leg, a foreleg
};

/** \brief Whether each opening of the mesh at the cut is closed by a fan of triangles around its centre. */
enum class Stump : char { Open, Closed };

/** \brief Cuts off what lies within 0.3 of the diameter around the extremity of a limb, and all pieces of the rest but
 * the largest.
 *
 * Distances are shortest paths along the edges of the mesh.
 * \param[in] mesh surface with faces
 * \param[in] truth pairs of partners; up to a hundred of them, evenly numbered, are looked at
 * \return the centres of fans have no origin
 * \throws pcl::BadArgumentException no pair is as far apart as 0.35 of the diameter: the body has no such limb */
DisturbedSurface
cutLimb(const Surface& mesh, const GroundTruth& truth, Limb limb, Stump stump);

} // namespace symmetry
} // namespace pcl
