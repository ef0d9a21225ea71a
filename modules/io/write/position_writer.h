/** \file
 * \brief Positions in output files, at the place where the input had them.
 */
#pragma once

#include "io/write/record_writer.h"

#include <pcl/symmetry/surface.h>

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Whether positions are written as doubles: only where floats would not reach, for PCL loads none but floats
 * into its point types. */
inline bool
needsDoubles(const Surface& surface)
{
  return surface.offset[0] != 0.0 || surface.offset[1] != 0.0 || surface.offset[2] != 0.0;
}

/** \brief Appends x y z of a place, with the offset added again. */
inline void
appendPosition(std::string& bytes, const Surface& surface, const Vector3& position)
{
  if (!needsDoubles(surface))
    return appendBytes(bytes, position);
  for (std::size_t i = 0; i < 3; ++i)
    appendBytes(bytes, double{position[i]} + surface.offset[i]);
}

/** \brief Appends x y z of a point, with the offset added again. */
inline void
appendPosition(std::string& bytes, const Surface& surface, std::size_t point)
{
  appendPosition(bytes, surface, surface.points[point]);
}

/** \brief Properties x y z of a PLY header. */
inline std::string
plyPosition(const Surface& surface)
{
  const std::string type = needsDoubles(surface) ? "double" : "float";
  return "property " + type + " x\nproperty " + type + " y\nproperty " + type + " z\n";
}

/** \brief Sizes of x y z in a PCD header. */
inline std::string
pcdPositionSizes(const Surface& surface)
{
  return needsDoubles(surface) ? "8 8 8" : "4 4 4";
}

} // namespace symmetry
} // namespace pcl
