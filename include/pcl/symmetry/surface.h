/** \file
 * \brief The surface that every algorithm of this module works on: flat arrays, no PCL types.
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
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

/** \brief Values that a file holds for each point and that no algorithm uses, such as colours or intensities. */
struct PointField {
  std::string name;            ///< as in the file
  char kind = 'F';             ///< F: floating point, I: signed integer, U: unsigned integer
  std::size_t value_bytes = 4; ///< of one value: 1, 2, 4 or 8
  std::size_t count = 1;       ///< values per point
  std::vector<char> values;    ///< of all points, in their order and this machine's byte order
};

/** \brief What a file says about its points besides their positions and normals. */
struct PointFields {
  std::vector<PointField> fields; ///< in the order of the file
  std::size_t width = 0;          ///< of the raster of an organised cloud; 0: there is none
  std::size_t height = 0;         ///< width times height is the number of points
};

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

  /** What was subtracted from the positions that the file holds: readSurface() brings map coordinates, which a float
   * cannot tell apart, near the origin, and the writers add it again. Zero otherwise; no algorithm looks at it. */
  std::array<double, 3> offset = {0.0, 0.0, 0.0};
  std::vector<std::string> notes = {};            ///< what the reader passed over or changed, a sentence each
  std::shared_ptr<const PointFields> fields = {}; ///< for the labelled file; may be empty. Shared: copies cost nothing

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
