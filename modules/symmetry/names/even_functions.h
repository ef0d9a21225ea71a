/** \file
 * \brief Eigenfunctions that a symmetry keeps.
 */
#pragma once

#include "symmetry/samples/laplacian_basis.h"
#include "symmetry/samples/sample_map.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief The lowest eigenfunctions of the Laplacian among those with the same value at both partners.
 *
 * They are the eigenfunctions of one half of the surface, with a free boundary at the axis: where two surfaces are alike,
 * those of one are those of the other, whichever half is called what. */
struct EvenFunctions {
  Eigen::MatrixXd functions;   ///< samples x count, mean square 1; without the constant one
  Eigen::VectorXd eigenvalues; ///< rising
};

/** \brief Of the span of the lowest eigenfunctions the part that a map keeps.
 * \param[in] map partner of each sample; a sample without one is its own */
EvenFunctions
evenFunctions(const LaplacianBasis& basis, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
