/** \file
 * \brief The area that each point of a surface stands for.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A third of the area of the triangles around every point; all alike where there are no triangles. */
std::vector<float>
pointAreas(const PreparedSurface& surface);

} // namespace symmetry
} // namespace pcl
