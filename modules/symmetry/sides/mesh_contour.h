/** \file
 * \brief Zero line of a vertex function on triangles.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Where a function that is linear along an edge is zero. */
struct ZeroCrossing {
  Index from = no_index;
  Index to = no_index;
  float share = 0.0F; ///< of the way from one to the other, in [0, 1]

  /** \brief The end that is nearer to it; the first where both are as near. */
  Index
  nearerEnd() const
  {
    return share <= 0.5F ? from : to;
  }
};

/** \brief The place of a crossing. */
Vector3
placeOf(const ZeroCrossing& crossing, const std::vector<Vector3>& points);

/** \brief The crossing of the edge between two vertices at which a function has different signs. */
ZeroCrossing
crossingBetween(Index a, Index b, const std::vector<float>& values);

/** \brief A line along which a function is zero. */
struct ZeroLine {
  std::vector<ZeroCrossing> crossings; ///< in order; that of the first is not repeated at the end
  bool closed = false;
};

/** \brief The lines along which a function changes its sign.
 *
 * A line crosses edges from triangle to triangle. The nearer ends of consecutive crossings are the same vertex or joined
 * by an edge.
 * \param[in] triangles faces; edges that more than two of them share end the lines that reach them
 * \param[in] values one per vertex; zero counts as positive
 */
std::vector<ZeroLine>
zeroContours(const std::vector<Triangle>& triangles, const std::vector<float>& values);

} // namespace symmetry
} // namespace pcl
