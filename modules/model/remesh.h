/** \file
 * \brief From many sliver triangles to a wanted number of good ones.
 */
#pragma once

#include "model/editable_mesh.h"
#include "model/implicit_surface.h"

#include <cstddef>
#include <functional>

namespace pcl {
namespace symmetry {

/** \brief Wanted edge length at a place, relative to other places. */
using SizeField = std::function<double(const Eigen::Vector3d&)>;

/** \brief Collapses edges, the shortest in relation to the wanted length first, until few enough vertices are left.
 *
 * \param[in,out] mesh vertices are kept on \a surface, those of the boundary on x = 0 as well
 * \param[in] surface the surface that the mesh stands for
 * \param[in] size wanted edge length, up to a factor
 * \param[in] vertices how many are wanted once the mesh is mirrored: a vertex counts twice unless it is on the
 * boundary; for a mesh without boundary, twice the number
 *
 * \return whether the number was reached, to within one
 *
 * Cost: n log n.
 */
bool
reduce(EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size, std::size_t vertices);

/** \brief Rounds of edge flips towards six neighbours per vertex and tangential smoothing, on the surface.
 *
 * Vertices of the boundary move along it. Evens out the triangles; the number of vertices stays.
 */
void
relax(EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size, int rounds);

/** \brief Moves a point onto the surface; with \a in_plane it stays at x = 0 exactly. */
Eigen::Vector3d
projectVertex(const ImplicitSurface& surface, const Eigen::Vector3d& point, bool in_plane);

} // namespace symmetry
} // namespace pcl
