/** \file
 * \brief Guesses of how a reflection might act on the spectral coordinates of a surface.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/samples/laplacian_basis.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief One guess: a symmetric orthogonal matrix on the non-constant spectral coordinates. */
struct SymmetryHypothesis {
  Eigen::MatrixXf action; ///< d x d
};

/** \brief All diagonal matrices of +-1 but the identity: where no eigenvalue is repeated, an isometric involution is
 * one of them \cite ovsjanikov2008symmetries. 2^d - 1 guesses. */
std::vector<SymmetryHypothesis>
signPatternHypotheses(int dimensions);

/** \brief The most consistent ways to pair up the extremities, each made an action on the spectral coordinates.
 *
 * Every extremity is swapped with another one, stationary (head, tail, nose), or left out; a way is judged by how
 * well it keeps the mutual distances in proportion to how far it moves the extremities.
 * \param[in] count how many guesses at most
 */
std::vector<SymmetryHypothesis>
extremityHypotheses(const LandmarkSurface& landmarks, const LaplacianBasis& basis, int dimensions, std::size_t count);

} // namespace symmetry
} // namespace pcl
