/** \file
 * \brief Surfaces of unit size, whatever the unit of the input.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

namespace pcl {
namespace symmetry {

/** \brief Moves the middle of the surface's box to the origin and scales its longest side to 1, in double: coordinates
 * may be huge.
 *
 * The box is that of a mesh's largest component, since the others take no part, or of all points of a cloud. What does
 * not take part is outside the box: were it far away, it would leave few bits for all others. */
void
normalizeScale(PreparedSurface& surface);

/** \brief The same for all points of a surface that was normalised by a part of them, with the lengths of its graph. */
void
renormalizeScale(PreparedSurface& surface);

} // namespace symmetry
} // namespace pcl
