/** \file
 * \brief Lines on a cloud joined over gaps.
 */
#pragma once

#include "symmetry/sides/mesh_contour.h"
#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Joins ends of open lines, also those of one line, where a short path over the surface along the zero of the
 * function leads from one to the other, or where they all but meet, the nearest first.
 *
 * A cloud is denser in some places than in others, and where its graph has few edges across the axis a line breaks off.
 * It stays open where the surface itself has an end: the other end is far away then, or the way to it leaves the axis.
 * \param[in] surface its points and graph
 * \param[in] values zero along the lines, and as large as the distance from them
 * \param[in] lines of at least two crossings each; a place of a path between them is a crossing without extent
 */
std::vector<ZeroLine>
joinedLines(const PreparedSurface& surface, const std::vector<float>& values, std::vector<ZeroLine> lines);

/** \brief Length of a line, with the way from its last crossing to the first where it is closed. */
float
lengthOf(const ZeroLine& line, const std::vector<Vector3>& points);

} // namespace symmetry
} // namespace pcl
