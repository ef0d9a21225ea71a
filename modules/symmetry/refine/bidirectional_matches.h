/** \file
 * \brief Matches between places of a surface, read both ways, and what they say of the places between them.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The matches of all samples with their partners, each in both directions.
 *
 * A reflection is its own inverse: that p is the partner of a sample s says of p's surroundings what it says of those
 * of s. Where a map is not quite its own inverse, the two directions of it are averaged.
 */
class BidirectionalMatches {
public:
  /** \param[in] surface, coarse referred to, not copied
   * \param[in] partners point that is the partner of each sample */
  BidirectionalMatches(const PreparedSurface& surface, const CoarseSurface& coarse, const std::vector<Index>& partners);

  /** \brief Where the matches around a point put its partner: in space, near the surface.
   *
   * Moving least squares (P. Lancaster, K. Salkauskas, 1981 \cite lancaster1981surfaces) over the matches that start in
   * the cell of the point or one adjacent to it, linear in the tangent plane and damped towards the weighted mean,
   * which is what remains where they do not span the plane (on a finger or a tail a cell wide). */
  Vector3
  imageOf(Index point) const;

private:
  struct Match {
    Index from;
    Index to;
  };

  const PreparedSurface& surface_;
  const CoarseSurface& coarse_;
  std::vector<std::uint32_t> offsets_; ///< matches from cell i: [offsets_[i], offsets_[i + 1])
  std::vector<Match> matches_;
  std::vector<float> spacing_; ///< mean distance of each sample from those of the adjacent cells
};

} // namespace symmetry
} // namespace pcl
