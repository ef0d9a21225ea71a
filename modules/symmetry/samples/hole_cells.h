/** \file
 * \brief The cells of a coarse surface along holes: what should lie opposite them may be missing.
 */
#pragma once

#include "geodesic/farthest_point_sampling.h"
#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Marks the cells that holes reach into.
 *
 * A hole is a connected rim that is at least two cells long, of a cloud five, smaller ones are cracks, and at most
 * 0.3 of the longest side of the surface, larger ones are the border of an open surface. A point of a mesh lies on a
 * rim where its triangles do not close around it; one of a cloud, where its neighbours leave out almost half of the
 * directions in its tangent plane, or next to such a point, where they leave out a third: edges are tracked in this way
 * in images (J. Canny, 1986 \cite canny1986edge). None are looked for in a cloud that had to be smoothed. Cost O(n).
 *
 * \param[in] cells the samples and the cell of each point
 * \param[in] spacing mean distance between adjacent samples
 * \return one entry per cell, not 0: at a hole */
std::vector<char>
cellsAtHoles(const PreparedSurface& surface, const FarthestPointSamples& cells, float spacing);

} // namespace symmetry
} // namespace pcl
