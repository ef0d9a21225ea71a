/** \file
 * \brief A small surface and a result that belongs to it.
 */
#pragma once

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief A roof of two rectangles: points 0-1 on the source side, 2-3 on the ridge, 4-5 on the target side. */
inline Surface
roof()
{
  Surface surface;
  surface.points = {{-1, 0, 0}, {-1, 3, 0}, {0, 0, 0.5F}, {0, 3, 0.5F}, {1, 0, 0}, {1, 3, 0}};
  surface.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  return surface;
}

/** \brief A line through points of a surface. */
inline Polyline
lineThrough(const Surface& surface, const std::vector<Index>& points, bool closed)
{
  Polyline line{points, closed};
  for (const Index v : points) {
    AxisPoint place;
    place.position = surface.points[static_cast<std::size_t>(v)];
    place.arc_length = 0.5F * static_cast<float>(line.curve.size());
    place.normal = {0.0F, 0.0F, 1.0F};
    place.across = {-1.0F, 0.0F, 0.0F};
    place.nearest = v;
    line.curve.push_back(place);
  }
  return line;
}

/** \brief The reflection of roof(). */
inline SymmetryResult
roofSymmetry()
{
  SymmetryResult result;
  result.status = SymmetryStatus::Symmetric;
  result.confidence = 0.9F;
  result.partners = {4, 5, 2, no_index, 0, 1};
  result.confidences = {1.0F, 0.75F, 0.5F, 0.0F, 1.0F, 0.1F};
  result.support = {1.0F, 0.9F, 0.8F, 0.0F, 0.25F, 0.5F};
  result.sides = {Side::Source, Side::Source, Side::Axis, Side::Axis, Side::Target, Side::Target};
  result.regions = {Region::Source1, Region::Source2, Region::Centre, Region::None, Region::Target1, Region::Target2};
  result.matches = {{0, 4, 2, 0.25F}, {1, 5, no_index, 0.0F}};
  result.axis = {lineThrough(roof(), {2, 3}, false)};
  result.diameter = 3.5F;
  result.input.points = 6;
  result.input.faces = 4;
  result.input.used = 5;
  result.input.non_finite = 1;
  result.input.components = 1;
  result.map.matched = 5;
  result.map.axis = 2;
  result.map.involution = 1.0F;
  result.seconds = {{"read", 0.125}, {"graph", 0.25}, {"write", 0.0625}};
  return result;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
