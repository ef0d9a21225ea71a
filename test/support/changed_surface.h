/** \file
 * \brief Ways to write down a surface that leave its symmetry what it is.
 */
#pragma once

#include "model/random_numbers.h"

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief A surface written down in another way. */
struct ChangedSurface {
  Surface surface;
  std::vector<Index> number; ///< of every old point among the new ones
  std::vector<Index> origin; ///< old point of every new one
};

/** \brief Every point moved, in the old order. */
template <typename Move>
ChangedSurface
movedPoints(const Surface& surface, Move move)
{
  ChangedSurface changed{surface, std::vector<Index>(surface.size()), {}};
  for (Vector3& p : changed.surface.points) {
    p = move(p);
  }
  std::iota(changed.number.begin(), changed.number.end(), 0);
  changed.origin = changed.number;
  return changed;
}

inline ChangedSurface
unchanged(const Surface& surface)
{
  return movedPoints(surface, [](const Vector3& p) { return p; });
}

/** \brief Points in an order by chance, faces in another. */
inline ChangedSurface
permuted(const Surface& surface)
{
  ChangedSurface changed = unchanged(surface);
  RandomNumbers random(7);
  random.shuffle(changed.number);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    changed.surface.points[changed.number[v]] = surface.points[v];
    changed.origin[changed.number[v]] = static_cast<Index>(v);
  }
  for (Triangle& t : changed.surface.triangles) {
    t = {changed.number[t[1]], changed.number[t[2]], changed.number[t[0]]};
  }
  random.shuffle(changed.surface.triangles);
  return changed;
}

/** \brief Turned about all axes, and moved by three times its height. */
inline ChangedSurface
turnedAndMoved(const Surface& surface)
{
  return movedPoints(surface, [](const Vector3& p) {
    const Vector3 once{0.6F * p[0] - 0.8F * p[1], 0.8F * p[0] + 0.6F * p[1], p[2]};
    return Vector3{once[0] + 3.0F, 0.28F * once[1] - 0.96F * once[2] - 5.0F, 0.96F * once[1] + 0.28F * once[2] + 1.0F};
  });
}

inline ChangedSurface
scaledBy(const Surface& surface, float factor)
{
  return movedPoints(surface, [factor](const Vector3& p) {
    return Vector3{factor * p[0], factor * p[1], factor * p[2]};
  });
}

/** \brief The mirror image, with faces that look outwards. */
inline ChangedSurface
mirroredInSpace(const Surface& surface)
{
  ChangedSurface changed = movedPoints(surface, [](const Vector3& p) { return Vector3{p[0], -p[1], p[2]}; });
  for (Triangle& t : changed.surface.triangles) {
    std::swap(t[1], t[2]);
  }
  return changed;
}

/** \brief Every third point comes twice; faces take the one or the other. */
inline ChangedSurface
withDuplicates(const Surface& surface)
{
  ChangedSurface changed = unchanged(surface);
  std::vector<Index> copy = changed.number;
  for (std::size_t v = 0; v < surface.size(); v += 3) {
    copy[v] = static_cast<Index>(changed.surface.size());
    changed.surface.points.push_back(surface.points[v]);
    changed.origin.push_back(static_cast<Index>(v));
  }
  for (std::size_t i = 0; i < changed.surface.triangles.size(); i += 2) {
    for (Index& v : changed.surface.triangles[i]) {
      v = copy[v];
    }
  }
  return changed;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
