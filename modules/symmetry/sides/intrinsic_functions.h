/** \file
 * \brief Functions of the shape alone that a symmetry keeps, on the samples of a surface.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/laplacian_basis.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief A function brought to mean 0 and mean square 1 over the surface; all zero where it is constant. */
Eigen::VectorXd
standardized(Eigen::VectorXd function, const CoarseSurface& coarse);

/** \brief Heat kernel signature: logarithm of the heat that is left at each sample after a time, on a surface of area 1
 * (J. Sun et al.: A concise and provably informative multi-scale signature based on heat diffusion, 2009
 * \cite sun2009concise). */
Eigen::VectorXd
heatSignature(const LaplacianBasis& basis, double time);

/** \brief Plus one if the normals point outwards, as seen from the middle of the surface, minus one if inwards. An open
 * sheet bulges to one side, which counts as outside. */
double
outwards(const CoarseSurface& coarse);

/** \brief Plus one where the corners of a triangle of the samples are in counter-clockwise order as the normals see
 * them, minus one where they are not. */
double
turnOf(const Triangle& triangle, const CoarseSurface& coarse);

} // namespace symmetry
} // namespace pcl
