/** \file
 * \brief The surface that every algorithm of this module works on: flat arrays, no PCL types.
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Number of a point of a surface, 0-based; -1 stands for "none". Same width as pcl::index_t. */
using Index = std::int32_t;

/** \brief The value of an Index that refers to nothing. */
constexpr Index no_index = -1;

/** \brief Position or direction: x, y, z. */
using Vector3 = std::array<float, 3>;

/** \brief Three point numbers, counter-clockwise as seen from outside. */
using Triangle = std::array<Index, 3>;

/** \brief A triangle mesh, or a point cloud where \a triangles is empty.
 *
 * Lengths are in whatever unit the points are given in: no algorithm assumes one. Points may be non-finite,
 * duplicated or unused by any triangle; each algorithm says what it does with them.
 * \ingroup symmetry
 */
struct Surface {
  std::vector<Vector3> points;     ///< n positions
  std::vector<Triangle> triangles; ///< m faces; empty for a point cloud
  std::vector<Vector3> normals;    ///< n unit normals, or empty where none are known

  /** \brief Number of points. */
  std::size_t
  size() const
  {
    return points.size();
  }

  /** \brief Whether it is a mesh: a point cloud has no faces. */
  bool
  hasFaces() const
  {
    return !triangles.empty();
  }
};

} // namespace symmetry
} // namespace pcl
