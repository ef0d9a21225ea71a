/** \file
 * \brief The faces around the ends of open sides, as far as it takes to tell a seam from two sheets.
 */
#pragma once

#include "symmetry/surface/open_sides.h"
#include "symmetry/surface/prepared_surface.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Share of the length of a side within which places are the same but for rounding: far below what the side is
 * long, far above the last digits. */
constexpr double rounding_share = 0.01;

/** \brief Radians by which the faces of two sheets so close together diverge at most. */
constexpr float parallel_faces = 0.05F;

/** \brief Distance of two places, in double: no unit is too small. */
double
lengthBetween(const Vector3& a, const Vector3& b);

/** \brief The part of a face around one of its corners, as the directions of its two sides. */
struct FaceCorner {
  Vector3 first;
  Vector3 second;

  Vector3
  bisector() const;

  /** \brief Whether a direction points into the face, at an angle with its sides and in its plane. */
  bool
  contains(const Vector3& direction) const;
};

/** \brief The ends of open sides of a mesh, numbered in their order, with the faces around them. */
class OpenCorners {
public:
  /** The surface is referred to, not copied. */
  OpenCorners(const PreparedSurface& surface, const std::vector<OpenSide>& sides);

  std::size_t
  size() const
  {
    return open_.points().size();
  }

  Index
  point(std::size_t i) const
  {
    return open_.points()[i];
  }

  const Vector3&
  place(std::size_t i) const
  {
    return places_[point(i)];
  }

  /** \brief How far rounding moves a point: a share of the shortest side of the triangles around it. */
  double
  tolerance(std::size_t i) const
  {
    return tolerances_[i];
  }

  std::vector<FaceCorner>
  facesAround(std::size_t i) const;

  /** \brief Whether a face of one point lies over a face of the other, as where two sheets are close together. */
  bool
  lieOver(std::size_t i, std::size_t j) const;

private:
  const std::vector<Vector3>& places_;
  OpenPoints open_;
  std::vector<double> tolerances_;
};

} // namespace symmetry
} // namespace pcl
