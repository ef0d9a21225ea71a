/** \file
 * \brief Nearest rows of a matrix, found by looking at all of them.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Targets laid out for the kernel that compares queries with all of them.
 *
 * In a few dozen dimensions no tree saves much: every target is compared with every query, 16 targets side by side.
 * The answer is the same for every instruction set and any number of threads.
 */
class RowSearch {
public:
  /** \brief No targets. */
  RowSearch() = default;

  /** \param[in] targets one per row; copied */
  explicit RowSearch(const Eigen::MatrixXf& targets);

  /** \brief For each row of \a queries the target at the least Euclidean distance (ties: the lowest).
   * \param[in] queries one per row, of as many columns as the targets */
  std::vector<Index>
  nearest(const Eigen::MatrixXf& queries) const;

private:
  Eigen::Index dimensions_ = 0;
  std::vector<float> targets_; ///< in blocks, see KernelTable::nearest_rows
  std::vector<float> half_norms_;
};

} // namespace symmetry
} // namespace pcl
