/** \file
 * \brief Colours of the sides, the same in files and pictures.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

#include <array>
#include <cstdint>

namespace pcl {
namespace symmetry {

/** \brief Red, green, blue, 0 to 255. */
using Colour = std::array<std::uint8_t, 3>;

/** \brief Colour of a side. Blue and orange differ for every kind of colour vision (Okabe and Ito 2008
 * \cite okabe2008color), and the axis is darker than both. */
constexpr Colour
colourOf(Side side)
{
  switch (side) {
  case Side::Source:
    return {0, 114, 178};
  case Side::Target:
    return {230, 159, 0};
  case Side::Axis:
    return {120, 10, 25};
  default:
    return {170, 170, 170};
  }
}

} // namespace symmetry
} // namespace pcl
