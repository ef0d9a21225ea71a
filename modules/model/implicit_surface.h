/** \file
 * \brief A smooth closed surface described by round cones that melt into each other.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The convex hull of two spheres; with equal ends a sphere. */
class RoundCone {
public:
  /** \param[in] start centre of one sphere
   *  \param[in] start_radius its radius
   *  \param[in] end centre of the other one: where the start is, or farther away than the radii differ
   *  \param[in] end_radius its radius */
  RoundCone(const Eigen::Vector3d& start, double start_radius, const Eigen::Vector3d& end, double end_radius);

  /** \brief Distance of a point, negative inside, and its gradient: exact, of slope one everywhere. */
  double
  signedDistance(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const;

  const Eigen::Vector3d&
  start() const
  {
    return start_;
  }

  const Eigen::Vector3d&
  end() const
  {
    return end_;
  }

  double
  startRadius() const
  {
    return start_radius_;
  }

  double
  endRadius() const
  {
    return end_radius_;
  }

private:
  Eigen::Vector3d start_;
  Eigen::Vector3d end_;
  double start_radius_;
  double end_radius_;
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero(); ///< of the axis, of unit length
  double length_ = 0.0;                                 ///< of the axis
  double taper_ = 0.0;                                  ///< loss of radius per length
  double lean_ = 0.0; ///< how far back along the axis a normal of the mantle starts, per distance from the axis
};

/** \brief The zero set of the soft minimum f = -k log sum exp (-d_i / k) of the distances to round cones.
 *
 * f is the distance to the nearest cone but for the rounding of creases, its slope is at most one, and it does not
 * depend on the order of the cones but for rounding. Cones farther than 12 k beyond the nearest one do not count.
 */
class ImplicitSurface {
public:
  /** \param[in] cones at least one
   *  \param[in] blend k, the width of the rounding, a length above 0 */
  ImplicitSurface(std::vector<RoundCone> cones, double blend);

  /** \brief f at a point. Thread-safe. */
  double
  value(const Eigen::Vector3d& point) const;

  /** \brief f and its gradient at a point. Thread-safe. */
  double
  value(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const;

  /** \brief The point moved onto the surface along the gradient (three Newton steps). */
  Eigen::Vector3d
  project(Eigen::Vector3d point) const;

  /** \brief Corner of a box that holds the whole surface. */
  const Eigen::Vector3d&
  lowest() const
  {
    return lowest_;
  }

  /** \brief The opposite corner. */
  const Eigen::Vector3d&
  highest() const
  {
    return highest_;
  }

private:
  void
  measureBox();
  void
  indexCones();
  const std::vector<std::uint16_t>&
  conesNear(const Eigen::Vector3d& point) const;

  std::vector<RoundCone> cones_;
  double blend_;
  Eigen::Vector3d lowest_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d highest_ = Eigen::Vector3d::Zero();
  double cell_ = 1.0; ///< edge of a cell of the index
  Eigen::Array3i cells_ = Eigen::Array3i::Ones();
  std::vector<std::vector<std::uint16_t>> near_; ///< per cell: the cones that count somewhere in it
  std::vector<std::uint16_t> all_;               ///< for points outside the box
};

} // namespace symmetry
} // namespace pcl
