/** \file
 * \brief Bones with joints, and the flesh around them.
 */
#pragma once

#include "model/implicit_surface.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief One degree, in radians: angles of bones are in degrees. */
constexpr double degree = 3.14159265358979323846 / 180.0;

/** \brief A bone, which turns about its joint and carries the bones that name it as parent. */
struct Bone {
  std::string name;
  int parent = -1;
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();
  Eigen::Vector3d lowest_turn = Eigen::Vector3d::Zero();  ///< smallest angles about x, y, z in degrees
  Eigen::Vector3d highest_turn = Eigen::Vector3d::Zero(); ///< largest ones
};

/** \brief A round cone that moves with a bone. */
struct Flesh {
  int bone = -1;
  RoundCone cone;
};

/** \brief A body in its rest pose: y points up, z to the front, x to the body's left.
 *
 * A parent comes before its children. A symmetric plan is its own mirror image about x = 0.
 */
class BodyPlan {
public:
  /** \param[in] blend width of the rounding between pieces of flesh
   *  \param[in] detail coarsest lattice that keeps all limbs apart and in one piece */
  BodyPlan(double blend, double detail) : blend_(blend), detail_(detail)
  {
  }

  /** \brief Adds a bone.
   *  \return its number */
  int
  addBone(const std::string& name,
          int parent,
          const Eigen::Vector3d& joint,
          const Eigen::Vector3d& lowest_turn,
          const Eigen::Vector3d& highest_turn);

  /** \brief Adds a piece of flesh. */
  void
  addFlesh(int bone, const Eigen::Vector3d& start, double start_radius, const Eigen::Vector3d& end, double end_radius);

  /** \brief Adds the mirror image of every bone and piece of flesh off the plane x = 0.
   *
   * A bone is off the plane when its joint is; its image is called as it is, with "left" replaced by "right". */
  void
  mirror();

  /** \brief Removes a bone, all bones that hang on it, and their flesh.
   *  \throws std::invalid_argument there is no bone of this name */
  void
  remove(const std::string& name);

  /** \brief Number of the bone of this name.
   *  \throws std::invalid_argument there is none */
  int
  find(const std::string& name) const;

  const std::vector<Bone>&
  bones() const
  {
    return bones_;
  }

  const std::vector<Flesh>&
  flesh() const
  {
    return flesh_;
  }

  /** \brief Coarsest lattice that keeps all limbs apart and in one piece. */
  double
  detail() const
  {
    return detail_;
  }

  /** \brief The skin in the rest pose. */
  ImplicitSurface
  surface() const;

private:
  std::vector<Bone> bones_;
  std::vector<Flesh> flesh_;
  double blend_;
  double detail_;
};

/** \name Symmetric bodies */
///@{
BodyPlan
humanPlan();
BodyPlan
quadrupedPlan();
BodyPlan
spiderPlan();
BodyPlan
birdPlan();
/** \brief Trunk, two to four pairs of limbs, head and tail of random number, place, length, thickness and joints. */
BodyPlan
creaturePlan(std::uint64_t seed);
///@}

/** \name Bodies without a symmetry */
///@{
BodyPlan
missingArmPlan();
BodyPlan
thirdArmPlan();
BodyPlan
missingLegPlan();
BodyPlan
handPlan();
BodyPlan
helixPlan();
/** \brief The creature of the same seed without one of its left limbs. */
BodyPlan
lameCreaturePlan(std::uint64_t seed);
/** \brief As a creature, but the limbs of either side are drawn without regard to the other. */
BodyPlan
askewCreaturePlan(std::uint64_t seed);
///@}

} // namespace symmetry
} // namespace pcl
