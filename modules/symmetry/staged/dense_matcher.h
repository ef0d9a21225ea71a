/** \file
 * \brief Exact nearest candidates by feature dissimilarity, for every vertex of a surface.
 */
#pragma once

#include "symmetry/staged/feature_vectors.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Finds for each query the candidate with the least dissimilarity(); ties go to the lowest row.
 *
 * The weights of the dissimilarity belong to the query alone, so boxes around groups of candidates give lower bounds:
 * a tree of boxes (median splits) is searched by branch and bound, the nearer box first. The answer is that of a scan
 * over all candidates, bit by bit; on surfaces it takes a few dozen evaluations instead of n. Memory: two copies of the
 * candidates at most.
 */
class DenseMatcher {
public:
  /** \param[in] candidates feature vectors; copied
   *
   * \param[in] floors see featureFloors () */
  DenseMatcher(const FeatureVectors& candidates, std::vector<float> floors);

  /** \brief The best candidate of every query.
   * \param[in] queries of the same dimensions as the candidates
   */
  std::vector<FeatureMatch>
  match(const FeatureVectors& queries) const;

private:
  struct Node {
    std::uint32_t begin; ///< its candidates are entries [begin, end) of order_
    std::uint32_t end;
    std::uint32_t children; ///< number of the first of two consecutive nodes; 0: a leaf
  };

  class Search;

  void
  split(const FeatureVectors& candidates, std::uint32_t node);

  std::size_t
  widestFeature(const FeatureVectors& candidates, const Node& node) const;

  void
  storeCandidates(const FeatureVectors& candidates);

  void
  boundNodes();

  std::size_t dimensions_;
  std::size_t padded_; ///< dimensions rounded up to whole vector registers
  std::vector<float> floors_;
  std::vector<std::uint32_t> order_; ///< candidate rows, those of a leaf side by side
  std::vector<float> features_;      ///< candidates in that order, padded
  std::vector<Node> nodes_;          ///< parents before children; the first is the root
  std::vector<float> lower_;         ///< per node: least value of each feature
  std::vector<float> upper_;
};

} // namespace symmetry
} // namespace pcl
