/** \file
 * \brief A map made visible: the colours of one side carried over to the other.
 */
#pragma once

#include "picture/palette.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Colours the source side and the axis by place, and each point of the target side as its partner.
 *
 * Red, green and blue grow along x, y and z across the box of the points. Where the map is right both sides look alike;
 * grey is what has no side or no partner, or is no finite place.
 * \param[in] surface its box is that of its finite points
 * \param[in] result of this surface
 * \return one per point */
std::vector<Colour>
transferColours(const Surface& surface, const SymmetryResult& result);

/** \brief Writes front and back of a mesh in these colours, side by side, as PNG.
 * \param[in] path the file appears whole or not at all
 * \param[in] surface with faces
 * \param[in] result of this surface
 * \throws pcl::IOException cannot be written */
void
writeColourTransfer(const std::string& path, const Surface& surface, const SymmetryResult& result);

} // namespace symmetry
} // namespace pcl
