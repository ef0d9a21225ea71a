/** \file
 * \brief Dense map: every vertex matched by its distances to the base vertices (paper, section 3.3).
 */
#pragma once

#include "symmetry/staged/base_vertices.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Partner of every vertex and how unlike it is. */
struct DenseMap {
  std::vector<Index> partners;
  std::vector<float> dissimilarities; ///< of the feature vectors, not negative
};

/** \brief Matches every vertex of either side with the vertices of the other side.
 *
 * \param[in] base base vertices of the last stage
 * \param[in] sides side function without zeros, see absorbSpecks (); where one side is empty no vertex has a partner
 */
DenseMap
denseMap(const BaseVertices& base, const std::vector<float>& sides);

} // namespace symmetry
} // namespace pcl
