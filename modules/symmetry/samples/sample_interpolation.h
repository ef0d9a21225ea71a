/** \file
 * \brief Carries values from the samples of a coarse surface over to every point.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Linear weights of the samples around each point: entries [offsets[v], offsets[v + 1]). They sum up to 1. */
struct SampleInterpolation {
  std::vector<std::uint32_t> offsets{0};
  std::vector<Index> samples;
  std::vector<float> weights;

  /** \brief Interpolated rows of \a values (samples x k) at point \a v. */
  Eigen::RowVectorXf
  at(std::size_t v, const Eigen::MatrixXf& values) const;

  /** \brief Interpolated value at point \a v. */
  float
  at(std::size_t v, const std::vector<float>& values) const;
};

/** \brief Moving least squares (P. Lancaster, K. Salkauskas, 1981 \cite lancaster1981surfaces) over the sample that
 * owns a point and those adjacent to it.
 *
 * The fit is linear in the tangent plane and damped towards the weighted mean, which is what remains where the samples
 * do not span the plane (on a finger or a tail a cell wide). Cost O(n).
 */
SampleInterpolation
interpolateFromSamples(const PreparedSurface& surface, const CoarseSurface& coarse);

} // namespace symmetry
} // namespace pcl
