/** \file
 * \brief From an implicit surface to triangles.
 */
#pragma once

#include "model/implicit_surface.h"

#include <pcl/symmetry/surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Triangles in double precision, while a model is being made. */
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles; ///< counter-clockwise as seen from outside
};

/** \brief What part of a surface is polygonised. */
enum class Extent {
  Whole,
  PositiveHalf ///< x >= 0 only; the boundary lies exactly on x = 0
};

/** \brief Marching tetrahedra on a body-centred cubic lattice: an oriented manifold, whatever the surface.
 *
 * \param[in] surface what to polygonise; features thinner than the lattice may be lost
 * \param[in] cell edge of the cubic cells, a length above 0
 * \param[in] extent whole, or one half of a surface that is mirror symmetric about x = 0
 * \return about 6.5 vertices per square of side \a cell; many triangles are slivers, see reduce and relax
 *
 * Cost: only cells near the surface are looked at; time and memory grow with the area over the square of \a cell.
 */
TriangleMesh
polygonize(const ImplicitSurface& surface, double cell, Extent extent);

} // namespace symmetry
} // namespace pcl
