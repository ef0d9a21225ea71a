/** \file
 * \brief What a reflection keeps, and what it turns over, at every sample of a coarse surface.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/laplacian_basis.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief Weights of the parts of a descriptor relative to the spectral coordinates. */
struct DescriptorWeights {
  int oriented_dimensions = 6; ///< spectral coordinates that take part in the orientation feature
  float orientation = 0.5F;
  float curvature = 0.3F;
};

/** \brief Descriptor of every sample: one row per sample in each part, each part with unit variance times its weight.
 *
 * - spectral: Y_a = f_a / sqrt (lambda_a), a = 1..d: a symmetry acts on them as an orthogonal matrix R, a reflection
 *   as a symmetric one;
 * - orientation: Omega_ab = n . (grad Y_a x grad Y_b) for the first few a < b: a reflection sends it to -R Omega R^T,
 *   a rotation to +R Omega R^T, which is what tells the two apart;
 * - curvature: n . (p - smoothed p) at three scales, kept by every symmetry.
 */
struct ShapeDescriptor {
  Eigen::MatrixXf spectral;
  Eigen::MatrixXf orientation;
  Eigen::MatrixXf curvature;
  int oriented_dimensions = 0; ///< number of spectral coordinates that take part in \a orientation

  /** \brief All parts of the first \a rows samples side by side: what matches are searched among. */
  Eigen::MatrixXf
  joined(Eigen::Index rows) const;

  /** \brief The descriptors that the partners of the first \a rows samples should have if the symmetry acts as
   * \a action (d x d) on the spectral coordinates and reverses the orientation. */
  Eigen::MatrixXf
  mirrored(const Eigen::MatrixXf& action, Eigen::Index rows) const;

  /** \brief As joined (), without the spectral coordinates. */
  Eigen::MatrixXf
  localParts(Eigen::Index rows) const;

  /** \brief As mirrored (), without the spectral coordinates. */
  Eigen::MatrixXf
  mirroredLocalParts(const Eigen::MatrixXf& action, Eigen::Index rows) const;
};

ShapeDescriptor
describeShape(const CoarseSurface& surface,
              const LaplacianBasis& basis,
              int dimensions,
              const DescriptorWeights& weights);

} // namespace symmetry
} // namespace pcl
