/** \file
 * \brief Which edges of a cloud pass through the place where two parts touch.
 */
#pragma once

#include "cloud/point_grid.h"
#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Tells edges that lead from one part of the body to another one through the place where they touch: moved a
 * little way into the body, along the normals, they meet the surface in between. On a bend of one surface they do not,
 * however sharp it is.
 *
 * An edge takes time in proportion to its length over the depth; one of more than ContactSettings::longest_barred depths
 * is no contact, and no more than ContactSettings::barrier_points are looked at for each piece of one. */
class ContactBarrier {
public:
  /** \param[in] points referred to, not copied; finite, within a few units of the origin
   * \param[in] normals of length 1, referred to
   * \param[in] depth how far edges are moved, above 0 */
  ContactBarrier(const std::vector<Vector3>& points, const std::vector<Vector3>& normals, float depth);

  bool
  isCrossedBy(const GraphEdge& edge) const;

private:
  bool
  isMetBetween(const Vector3& begin, const Vector3& end, const Vector3& a, const Vector3& b) const;

  const std::vector<Vector3>& points_;
  const std::vector<Vector3>& normals_;
  float clearance_; ///< where the surface bends inwards it comes nearer than the depth
  float depth_;
  PointGrid grid_;
};

} // namespace symmetry
} // namespace pcl
