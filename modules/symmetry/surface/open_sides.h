/** \file
 * \brief The sides of a mesh that have a triangle on one side only, and what is around their ends.
 */
#pragma once

#include "base/index_range.h"

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A side from a to b that only one triangle has; that runs from a to b as well. */
struct OpenSide {
  Index a = no_index;
  Index b = no_index;
  Index third = no_index; ///< corner of the triangle
  Index triangle = no_index;
};

/** \brief The open sides of the triangles between \a n points, by their lower end. Cost O(n). */
std::vector<OpenSide>
openSides(std::size_t n, const std::vector<Triangle>& triangles);

/** \brief The points at the ends of open sides, with the triangles around them. */
class OpenPoints {
public:
  /** The triangles are referred to, not copied. */
  OpenPoints(std::size_t n, const std::vector<Triangle>& triangles, const std::vector<OpenSide>& sides);

  /** \brief The points, ascending. */
  const std::vector<Index>&
  points() const
  {
    return points_;
  }

  /** \brief Calls visit (b, c) for the triangle (a, b, c) around a point a, one after another.
   * \param[in] i its place in points () */
  template <typename Visit>
  void
  visitTriangles(std::size_t i, Visit visit) const
  {
    for (std::size_t k = offsets_[i]; k < offsets_[i + 1]; ++k) {
      const Triangle& t = triangles_[around_[k]];
      const std::size_t at = t[0] == points_[i] ? 0 : t[1] == points_[i] ? 1 : 2;
      visit(t[(at + 1) % 3], t[(at + 2) % 3]);
    }
  }

private:
  const std::vector<Triangle>& triangles_;
  std::vector<Index> points_;
  std::vector<std::size_t> offsets_; ///< per point, into the next
  std::vector<Index> around_;        ///< triangles
};

} // namespace symmetry
} // namespace pcl
