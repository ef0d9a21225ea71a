#include "symmetry/names/exchanged_sides.h"

#include "symmetry/sides/mirror_plane.h"

#include <utility>

namespace pcl {
namespace symmetry {
namespace {

Side
other(Side side)
{
  return side == Side::Source ? Side::Target : side == Side::Target ? Side::Source : side;
}

Region
other(Region region)
{
  switch (region) {
  case Region::Source1:
    return Region::Target1;
  case Region::Target1:
    return Region::Source1;
  case Region::Source2:
    return Region::Target2;
  case Region::Target2:
    return Region::Source2;
  case Region::None:
  case Region::Centre:
    break;
  }
  return region;
}

MirrorPlane
turned(MirrorPlane plane)
{
  for (double& coordinate : plane.normal) {
    coordinate = -coordinate;
  }
  plane.offset = -plane.offset;
  return movedPlane(plane, 1.0, {}); // with its motion anew
}

} // namespace

void
exchangeSides(SymmetryResult& result)
{
  for (Side& side : result.sides) {
    side = other(side);
  }
  for (Region& region : result.regions) {
    region = other(region);
  }
  for (SymmetricMatch& match : result.matches) {
    std::swap(match.source, match.target);
  }
  for (std::size_t k = 0; k + 1 < result.extremities.size(); k += 2) {
    std::swap(result.extremities[k], result.extremities[k + 1]);
  }
  for (Polyline& line : result.axis) {
    for (AxisPoint& point : line.curve) {
      for (float& coordinate : point.across) {
        coordinate = -coordinate;
      }
    }
  }
  if (result.plane.normal != MirrorPlane{}.normal) {
    result.plane = turned(result.plane);
  }
}

} // namespace symmetry
} // namespace pcl
