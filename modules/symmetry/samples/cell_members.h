/** \file
 * \brief Which points of a surface belong to which sample.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Points of each cell: cell i owns entries [offsets[i], offsets[i + 1]) of points, ascending. */
struct CellMembers {
  std::vector<std::uint32_t> offsets;
  std::vector<Index> points;
};

CellMembers
membersOfCells(const CoarseSurface& coarse);

/** \brief At most so many points of each cell, evenly picked. */
CellMembers
thinnedMembers(const CellMembers& members, std::uint32_t maximum_per_cell);

} // namespace symmetry
} // namespace pcl
