/** \file
 * \brief Zero line of a vertex function on a mesh.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The lines along which a function changes its sign, as chains of vertices.
 *
 * A line crosses edges from triangle to triangle; each crossed edge gives the end where the function is closer to zero.
 * Consecutive vertices are the same or joined by an edge; a vertex may come several times in a row.
 * \param[in] triangles faces; edges that more than two of them share end the lines that reach them
 * \param[in] values one per vertex; zero counts as positive
 */
std::vector<Polyline>
zeroContours(const std::vector<Triangle>& triangles, const std::vector<float>& values);

} // namespace symmetry
} // namespace pcl
