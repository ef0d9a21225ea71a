/** \file
 * \brief Limbs of a surface, and what is left of it without one.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What lies between the end of a limb and its root. */
struct Limb {
  Index end = no_index;
  std::vector<float> distances; ///< of every point of the surface from the end
  float root = 0.0F;            ///< distance of the root from the end
  float girth = 0.0F;           ///< length of the curve around the root
  float share = 0.0F;           ///< of the area of the surface

  bool
  holds(Index point) const
  {
    return distances[point] <= root;
  }
};

/** \brief Finds the root of a limb: of the curves of points that are equally far from its end, at most half of the area
 * within, the shortest one for the area that it cuts off.
 *
 * Its isoperimetric ratio, the square of its length over that area, falls along a limb, as the area grows and the length
 * stays; that of a cone stays. Where the limb ends in a trunk the length grows faster. So the root is the last curve, from
 * the one with the least ratio outwards, whose ratio is as small but for noise (see doc/decisions/odd-limbs.md).
 * Cost: one shortest-path search.
 * \param[in] samples by which the surface is resolved: the area between curves that are six of their spacings apart tells
 * the length of the one in the middle
 * \return none where the ratio stays as small up to half of the area, as of a ball or of half a body: nothing ends there;
 * and of a surface without triangles */
std::optional<Limb>
findLimb(const PreparedSurface& surface, Index end, std::size_t samples);

/** \brief A part of a surface, and which one. */
struct PartOfSurface {
  PreparedSurface surface;
  std::vector<Index> points; ///< numbers in the whole of the points here, ascending
};

/** \brief The surface without a limb: the largest component of what is left. */
PartOfSurface
withoutLimb(const PreparedSurface& surface, const Limb& limb);

} // namespace symmetry
} // namespace pcl
