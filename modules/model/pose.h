/** \file
 * \brief Bending the joints of a body and taking its skin along.
 */
#pragma once

#include "model/body_plan.h"
#include "model/random_numbers.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Per bone: angles about x, y, z in degrees, applied in this order in the rest pose's axes. */
using Pose = std::vector<Eigen::Vector3d>;

/** \brief A pose with every angle drawn uniformly from the limits of its joint, then multiplied by \a bend.
 *
 * Left and right are drawn one by one, so that they differ. */
Pose
randomPose(const BodyPlan& plan, double bend, RandomNumbers& random);

/** \brief Moves points of the rest pose's skin as the bones move: dual quaternion skinning (Kavan et al. 2008
 * \cite kavan2008skinning).
 *
 * The weights fall off over about a fifth of the local radius of a limb around a joint, so that lengths change only
 * there. Cost: points times pieces of flesh.
 */
void
bendBody(const BodyPlan& plan, const Pose& pose, std::vector<Eigen::Vector3d>& points);

} // namespace symmetry
} // namespace pcl
