/** \file
 * \brief How far places are from a surface, and which of its points is nearest.
 */
#pragma once

#include "base/vector_math.h"
#include "cloud/ball_tree.h"
#include "symmetry/surface/prepared_surface.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Distances of places from a surface near by.
 *
 * Of a mesh from its triangles. Of a cloud from its points, or from the plane of a point that is no farther than its own
 * neighbours are: between points there is surface. */
class SurfaceDistance {
public:
  /** \param[in] surface referred to, not copied
   * \param[in] reach largest distance that is told */
  SurfaceDistance(const PreparedSurface& surface, float reach);

  /** \brief A place on the surface, and how far it is from another. */
  struct Nearest {
    Vector3 place{};
    float distance = 0.0F;
  };

  /** \brief The place on the surface that is nearest to another; nothing beyond the reach. */
  std::optional<Nearest>
  nearest(const Vector3& place) const;

  /** \brief Distance of a place from the surface, infinity beyond the reach. */
  float
  at(const Vector3& place) const;

private:
  Nearest
  nearestOfPlane(Index point, const Vector3& place) const;

  Nearest
  nearestOfTriangle(Index triangle, const Vector3& place) const;

  const PreparedSurface& surface_;
  float reach_;
  std::vector<Vector3> middles_; ///< of the triangles of a mesh
  std::vector<float> radii_;     ///< of the triangles; of a cloud: how far the plane of each point reaches
  BallTree tree_;                ///< of the triangles, or of the points of a cloud
};

} // namespace symmetry
} // namespace pcl
