#include "model/pose.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr double falloff = 0.2; // of the skin weights, in radii of the flesh

/** \brief A rigid motion p -> rotation * p + translation. */
struct Motion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

Eigen::Quaterniond
rotation(const Eigen::Vector3d& angles)
{
  const Eigen::Vector3d radians = degree * angles;
  return Eigen::AngleAxisd(radians.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(radians.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(radians.x(), Eigen::Vector3d::UnitX());
}

std::vector<Motion>
boneMotions(const BodyPlan& plan, const Pose& pose)
{
  std::vector<Motion> motions(plan.bones().size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Bone& bone = plan.bones()[i];
    const Motion parent = bone.parent < 0 ? Motion() : motions[static_cast<std::size_t>(bone.parent)];
    const Eigen::Quaterniond turn = rotation(pose[i]);
    motions[i].rotation = (parent.rotation * turn).normalized();
    // The joint stays where the parent takes it.
    motions[i].translation = parent.rotation * bone.joint + parent.translation - motions[i].rotation * bone.joint;
  }
  return motions;
}

/** \brief How much each bone moves a point of the skin; not normalised. */
void
skinWeights(const BodyPlan& plan, const Eigen::Vector3d& point, std::vector<double>& weights)
{
  std::fill(weights.begin(), weights.end(), 0.0);
  Eigen::Vector3d unused;
  for (const Flesh& piece : plan.flesh()) {
    const double radius = std::min(piece.cone.startRadius(), piece.cone.endRadius());
    const double distance = piece.cone.signedDistance(point, unused);
    weights[static_cast<std::size_t>(piece.bone)] += std::exp(-distance / (falloff * radius));
  }
}

/** \brief The dual quaternion mean of the bones' motions, applied to a point. */
Eigen::Vector3d
blend(const std::vector<Motion>& motions, const std::vector<double>& weights, const Eigen::Vector3d& point)
{
  const auto leader = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  Eigen::Vector4d real = Eigen::Vector4d::Zero();
  Eigen::Vector4d dual = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (weights[i] < 1e-9 * weights[leader])
      continue;
    const Motion& motion = motions[i];
    const Eigen::Vector3d half = 0.5 * motion.translation;
    const Eigen::Quaterniond shift = Eigen::Quaterniond(0.0, half.x(), half.y(), half.z()) * motion.rotation;
    // q and -q are the same rotation: take the one on the leader's side.
    const double sign = motion.rotation.dot(motions[leader].rotation) < 0.0 ? -weights[i] : weights[i];
    real += sign * motion.rotation.coeffs();
    dual += sign * shift.coeffs();
  }
  const double norm = real.norm();
  const Eigen::Quaterniond turn(Eigen::Vector4d(real / norm));
  const Eigen::Quaterniond shift(Eigen::Vector4d(dual / norm));
  return turn * point + 2.0 * (shift * turn.conjugate()).vec();
}

} // namespace

Pose
randomPose(const BodyPlan& plan, double bend, RandomNumbers& random)
{
  Pose pose;
  pose.reserve(plan.bones().size());
  for (const Bone& bone : plan.bones()) {
    Eigen::Vector3d& angles = pose.emplace_back();
    for (int k = 0; k < 3; ++k)
      angles[k] = bend * random.uniform(bone.lowest_turn[k], bone.highest_turn[k]);
  }
  return pose;
}

void
bendBody(const BodyPlan& plan, const Pose& pose, std::vector<Eigen::Vector3d>& points)
{
  const std::vector<Motion> motions = boneMotions(plan, pose);
  std::vector<double> weights(motions.size());
  for (Eigen::Vector3d& point : points) {
    skinWeights(plan, point, weights);
    point = blend(motions, weights, point);
  }
}

} // namespace symmetry
} // namespace pcl
