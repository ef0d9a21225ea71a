#include "symmetry/samples/cell_members.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {

CellMembers
membersOfCells(const CoarseSurface& coarse)
{
  CellMembers members;
  members.offsets.assign(coarse.size() + 1, 0);
  for (const Index owner : coarse.cells.owner) {
    ++members.offsets[owner + 1];
  }
  std::partial_sum(members.offsets.begin(), members.offsets.end(), members.offsets.begin());
  members.points.resize(coarse.cells.owner.size());
  std::vector<std::uint32_t> next(members.offsets.begin(), members.offsets.end() - 1);
  for (std::size_t v = 0; v < coarse.cells.owner.size(); ++v) {
    members.points[next[coarse.cells.owner[v]]++] = static_cast<Index>(v);
  }
  return members;
}

CellMembers
thinnedMembers(const CellMembers& members, std::uint32_t maximum_per_cell)
{
  CellMembers thinned;
  thinned.offsets.push_back(0);
  for (std::size_t cell = 0; cell + 1 < members.offsets.size(); ++cell) {
    const std::uint32_t size = members.offsets[cell + 1] - members.offsets[cell];
    const std::uint32_t step = std::max(1U, (size + maximum_per_cell - 1) / maximum_per_cell);
    for (std::uint32_t e = members.offsets[cell]; e < members.offsets[cell + 1]; e += step) {
      thinned.points.push_back(members.points[e]);
    }
    thinned.offsets.push_back(static_cast<std::uint32_t>(thinned.points.size()));
  }
  return thinned;
}

} // namespace symmetry
} // namespace pcl
