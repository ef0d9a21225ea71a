/** \file
 * \brief How a map changes distances around each landmark: where it is no isometry, whatever the pose does far away.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Relative change of nearby distances at landmarks.
 *
 * A reflection m is its own inverse, so d (i, m (j)) = d (m (i), j): both are distances from landmarks, which are known
 * at every sample and are interpolated at the partner points, so that the spacing of the samples does not blur them.
 * At landmark i it is the 80th percentile of |d (i, m (j)) - d (j, m (i))| / d (i, m (j)) over the landmarks j whose
 * partner lies at 5 to 25 % of the diameter from i: nearer ones are within the noise of the samples, a pose bends
 * what is farther. A pose moves joints, where all this is small; at the root of a limb without counterpart it is not. */
class LocalDistanceChange {
public:
  /** \brief Cost: the product of all distances with a sparse matrix.
   * \param[in] partners partner point of every sample */
  LocalDistanceChange(const SampledSurface& sampled, const std::vector<Index>& partners);

  /** \brief At every landmark; 0 where no partner is at that distance. */
  std::vector<float>
  everywhere() const;

  /** \brief At one landmark, over the landmarks without a mark alone; infinite where none of those is at that
   * distance. */
  float
  relativeTo(Index landmark, const std::vector<char>& left_out) const;

private:
  Eigen::MatrixXf to_partners_; ///< column j: distances from every landmark to the partner of landmark j
  float diameter_;
};

} // namespace symmetry
} // namespace pcl
