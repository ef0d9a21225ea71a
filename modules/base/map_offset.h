/** \file
 * \brief Positions far from the origin for their extent, as map coordinates are.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is to be subtracted from positions so that floats tell them apart.
 *
 * The points are moved where their middle is farther from zero along an axis than 256 times their spread, so that fewer
 * than 65536 steps of a float would be left across them; then all axes are moved along which zero is outside of them.
 * Middle and spread are those of the bulk: stray points count for nothing. The offset is a multiple of a power of two near the spread, so that positions that are floats are moved and moved back exactly.
 *
 * \param[in] points as rounded to floats; non-finite ones are passed over
 */
std::array<double, 3>
findOffset(const std::vector<Vector3>& points);

/** \brief Steps of single precision across the extent of the points at their place in the file; infinite where they are
 * at the origin, or all at one place. */
double
stepsAcross(const Surface& surface);

} // namespace symmetry
} // namespace pcl
