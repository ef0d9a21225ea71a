/** \file
 * \brief A side function whose zero line is smooth.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The side function after heat has flowed for a short while near where its sign changes.
 *
 * What a map of points says about the axis is as coarse as the points. The flow averages it along the axis, and it
 * keeps an antisymmetric function antisymmetric: the zero line stays where it is, as the points that a symmetry fixes
 * lie on a geodesic, whose sides it treats alike. Cotangent weights, so that it does not depend on how the surface is
 * divided into triangles (U. Pinkall, K. Polthier: Computing discrete minimal surfaces and their conjugates, 1993
 * \cite pinkall1993minimal), in implicit steps (M. Desbrun et al.: Implicit fairing of irregular meshes using diffusion
 * and curvature flow, 1999 \cite desbrun1999implicit).
 * \param[in] surface its triangles may be no manifold
 * \param[in] side_function one value per point, the sign is the side, proportional to the distance from the axis near it
 * \return the same farther away from the axis. Cost that of factorizing a sparse matrix of the points near it. */
std::vector<float>
smoothedNearAxis(const PreparedSurface& surface, const std::vector<float>& side_function);

} // namespace symmetry
} // namespace pcl
