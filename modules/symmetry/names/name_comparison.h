/** \file
 * \brief Whether the sides of two surfaces have the same names.
 */
#pragma once

#include "symmetry/names/comparable_surface.h"

namespace pcl {
namespace symmetry {

/** \brief How badly the best maps fit that carry source side to source side, and to target side. */
struct NameComparison {
  double same = 0.0;     ///< 0 is a perfect fit, about 0.3 that of two poses, 1 that of two animals
  double opposite = 0.0; ///< the same; equal to \a same where nothing can be told

  /** Product of the chiralities of both, see side_names.h, at most 1 in size: positive where the shapes, each by itself,
   * call the same side source. */
  double chiralities = 0.0;

  /** \brief Which fits better by what share of the worse one, and a little of the chiralities: positive for the same names,
   * in [-1, 1]. Where that is below SideNaming::doubtful the maps hardly tell, and the sign is that of the chiralities. */
  double
  margin() const;
};

/** \brief Compares two surfaces.
 *
 * Of the two halves of a surface, one as good as the other to all that is even, maps are made from surface to surface:
 * from 33 starts, upwards in their even functions (S. Melzi et al.: ZoomOut, 2019 \cite melzi2019zoomout) and guided by
 * their features. A map of the halves keeps the orientation, or turns it over; as maps of one body to another keep it,
 * the former carry source to source if the names are the same, the latter if they are not. Of either kind the one counts
 * that changes distances and features least, there and back. The result does not depend on the number of threads. */
NameComparison
compareNames(const ComparableSurface& first, const ComparableSurface& second);

} // namespace symmetry
} // namespace pcl
