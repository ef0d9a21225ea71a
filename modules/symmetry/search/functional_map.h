/** \file
 * \brief Symmetric maps as matrices on the eigenfunctions of the Laplacian, and their refinement upwards.
 *
 * M. Ovsjanikov et al.: Functional maps, a flexible representation of maps between shapes. ACM TOG 31(4), 2012.
 * \cite ovsjanikov2012functional
 * S. Melzi et al.: ZoomOut, spectral upsampling for efficient shape correspondence. ACM TOG 38(6), 2019.
 * \cite melzi2019zoomout
 */
#pragma once

#include "symmetry/samples/sample_map.h"
#include "symmetry/samples/shape_descriptor.h"
#include "symmetry/search/row_search.h"

#include <pcl/symmetry/surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief For each row of \a queries the row of \a targets at the least Euclidean distance (ties: the lowest). */
SampleMap
nearestRows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& targets);

/** \brief The symmetric matrix with eigenvalues +-1 that is nearest to \a matrix.
 *
 * A reflection is an isometry and its own inverse, so its matrix is orthogonal and symmetric; enforcing that averages
 * both directions of a map. */
Eigen::MatrixXf
nearestInvolution(const Eigen::MatrixXf& matrix);

/** \brief Refinement of maps among the first samples of a surface, going up through its eigenfunctions.
 *
 * The eigenfunctions know nothing of orientation: on a flat body, front and back are alike to the lowest of them. So
 * the local parts of the shape descriptor, which tell a reflection from a rotation, guide the matching.
 */
class UpwardRefinement {
public:
  /** \param[in] functions samples x k eigenfunctions
   * \param[in] descriptor of all samples; referred to, not copied
   * \param[in] samples how many samples (the first ones) take part
   * \param[in] dimensions numbers of functions to go through, rising
   * \param[in] guidance weight of the descriptor's local parts against the eigenfunctions */
  UpwardRefinement(const Eigen::MatrixXf& functions,
                   const ShapeDescriptor& descriptor,
                   Eigen::Index samples,
                   const std::vector<int>& dimensions,
                   float guidance);

  /** \brief Without guidance. */
  UpwardRefinement(const Eigen::MatrixXf& functions, Eigen::Index samples, const std::vector<int>& dimensions);

  /** \brief For each number of functions: the matrix of the map, made an involution, and the map of that matrix.
   * \param[in,out] map partner of each sample that takes part, among them
   * \return the last matrix */
  Eigen::MatrixXf
  refine(SampleMap& map) const;

private:
  struct Level {
    Eigen::MatrixXf functions;
    Eigen::MatrixXf pseudo_inverse;
    RowSearch search;    ///< among the functions, then the weighted local parts
    float weight = 0.0F; ///< of the local parts
  };

  SampleMap
  match(const Level& level, const Eigen::MatrixXf& matrix) const;

  const ShapeDescriptor* descriptor_ = nullptr; ///< null: no guidance
  std::vector<Level> levels_;
};

} // namespace symmetry
} // namespace pcl
