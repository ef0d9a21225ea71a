/** \file
 * \brief What the readers of all formats share: counts that are checked before memory is asked for, and polygons.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Points that an Index can number. */
constexpr std::uint64_t point_limit = 2147483647;

/** \brief True where \a count records of at least \a least_bytes each fit into \a available bytes. */
inline bool
fitsInto(std::uint64_t count, std::uint64_t least_bytes, std::uint64_t available)
{
  return least_bytes == 0 || count <= available / least_bytes;
}

/** \brief Bytes that may come of \a packed compressed ones: more than files that people have need, few enough that a small
 * file cannot eat the machine. */
constexpr std::uint64_t
mostUnpacked(std::uint64_t packed)
{
  constexpr std::uint64_t always_allowed = std::uint64_t{64} << 20;
  constexpr std::uint64_t largest_ratio = 32; // text and clouds of points that differ: 1 to 10
  return packed > always_allowed / largest_ratio ? packed * largest_ratio : always_allowed;
}

/** \brief Adds the triangle fan of a polygon around its first corner.
 *
 * Triangles with two equal corners are left out, and with them polygons of fewer than three corners: scans are full of
 * them, and they have no area.
 */
void
appendPolygon(const std::vector<Index>& corners, std::vector<Triangle>& triangles);

/** \brief Adds the triangles of a strip, every other one turned round so that all have the orientation of the first; -1
 * begins a new strip. Triangles with two equal corners are left out. */
void
appendStrip(const std::vector<Index>& corners, std::vector<Triangle>& triangles);

} // namespace symmetry
} // namespace pcl
