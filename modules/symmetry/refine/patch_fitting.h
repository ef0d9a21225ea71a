/** \file
 * \brief Reflections that carry patches of a surface onto other places of it.
 */
#pragma once

#include "cloud/point_grid.h"
#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/rigid_reflection.h"
#include "symmetry/samples/surface_patch.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The reflection of a patch and how badly its image fits the surface. */
struct PatchPlacement {
  RigidReflection reflection;
  float misfit = 1.0F; ///< 0: lies on the surface and faces as it does, 1: there is nothing like it
};

/** \brief Fits patches to the samples of a surface.
 *
 * Only places and normals count, not distances over the surface. What has no counterpart (a patch may take in a piece
 * of another part of the body that is in contact) costs no more than a constant and has no say in the fit. */
class PatchFitting {
public:
  /** \param[in] coarse referred to, not copied */
  explicit PatchFitting(const CoarseSurface& coarse);

  /** \brief The reflection that carries a patch to where a map has it.
   * \param[in] partners partner point of every sample, on \a surface */
  RigidReflection
  byMap(const SurfacePatch& patch, const PreparedSurface& surface, const std::vector<Index>& partners) const;

  /** \brief Moves the image of a patch to the best fit around (iterative closest points, P. Besl, N. McKay, 1992
   * \cite besl1992registration).
   * \param[in] limit given up where the misfit will hardly come below it
   * \param[in] enough misfit below which it is not improved */
  PatchPlacement
  settled(const SurfacePatch& patch, const RigidReflection& reflection, float limit = 1.0F, float enough = 0.0F) const;

  /** \brief Sample nearest to a place, among those that face as wanted if there are some; no_index if none is within
   * about two spacings. */
  Index
  nearestFacing(const Vector3& place, const Vector3& normal) const;

  /** \brief Mean distance between adjacent samples. */
  float
  spacing() const
  {
    return spacing_;
  }

private:
  float
  misfitAt(Index image, const Vector3& place, const Vector3& normal) const;

  const CoarseSurface& coarse_;
  float spacing_;
  PointGrid grid_; ///< of the samples

  struct OrientedSample {
    Vector3 place;
    Vector3 normal;
  };
  std::vector<OrientedSample> in_order_; ///< the samples in the order of the grid, next to each other in memory
};

} // namespace symmetry
} // namespace pcl
