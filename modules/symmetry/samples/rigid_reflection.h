/** \file
 * \brief The reflection and shift that carries some places of a surface onto others.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Two places with the normals there, one to be carried onto the other. */
struct OrientedMatch {
  Vector3 from;
  Vector3 from_normal;
  Vector3 to;
  Vector3 to_normal;
  float weight;
};

/** \brief An isometry of space that reverses orientation: x -> linear x + shift, det (linear) = -1. */
struct RigidReflection {
  Eigen::Matrix3f linear = -Eigen::Matrix3f::Identity();
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  float error = 0.0F; ///< weighted mean of the squared distances between the images and where they should be

  Vector3
  operator()(const Vector3& place) const;

  /** \brief The image of a direction; an outward normal becomes an outward normal. */
  Vector3
  turned(const Vector3& direction) const;
};

/** \brief Fits a reflection to matches that may lie off along the surface.
 *
 * First the closest reflection in the sense of least squares (W. Kabsch, 1976 \cite kabsch1976rotation, with the
 * determinant -1), then one step of the alignment of points to planes (Y. Chen, G. Medioni, 1992
 * \cite chen1992modelling), which lets places slide along the surface to where its shape fits.
 *
 * \param[in] matches positive weights; empty gives the reflection in the origin
 * \param[in] normal_reach length that a unit difference of normals counts as in the first fit
 */
RigidReflection
fitReflection(const std::vector<OrientedMatch>& matches, float normal_reach);

} // namespace symmetry
} // namespace pcl
