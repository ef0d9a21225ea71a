/** \file
 * \brief A zero line as a curve in space, with its directions.
 */
#pragma once

#include "symmetry/sides/mesh_contour.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The places where a line crosses edges, without those that nearly coincide.
 *
 * On a cloud, whose edges cross each other, the places lie to the left and right of the line: they are spaced evenly,
 * about an edge apart, and smoothed without shrinking (G. Taubin: A signal processing approach to fair surface design,
 * 1995 \cite taubin1995signal).
 * \param[in] side_function positive on the source side, to which AxisPoint::across points
 */
std::vector<AxisPoint>
curvePoints(const PreparedSurface& surface, const std::vector<float>& side_function, const ZeroLine& line);

} // namespace symmetry
} // namespace pcl
