/** \file
 * \brief Eigenfunctions of the Laplacian of a coarse surface.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief The lowest eigenfunctions, orthonormal with respect to the areas of the cells. */
struct LaplacianBasis {
  Eigen::MatrixXf functions;   ///< samples x count; column 0 is constant
  Eigen::VectorXf eigenvalues; ///< rising
  Eigen::VectorXf masses;      ///< areas of the cells, sum 1
};

/** \brief Solves L f = lambda M f with cotangent weights and lumped masses (U. Pinkall, K. Polthier: Computing discrete
 * minimal surfaces and their conjugates, 1993 \cite pinkall1993minimal), by shift-and-invert Lanczos.
 */
LaplacianBasis
laplacianBasis(const CoarseSurface& surface, int count);

} // namespace symmetry
} // namespace pcl
