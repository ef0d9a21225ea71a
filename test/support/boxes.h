/** \file
 * \brief Objects put together from closed boxes that share no corner, as people model furniture.
 */
#pragma once

#include "base/vector_math.h"

#include <pcl/symmetry/surface.h>

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Adds a box of eight corners and twelve faces that face outwards. */
inline void
addBox(Surface& surface, const Vector3& low, const Vector3& high)
{
  const auto first = static_cast<Index>(surface.size());
  for (int corner = 0; corner < 8; ++corner) {
    surface.points.push_back({(corner & 1) != 0 ? high[0] : low[0], (corner & 2) != 0 ? high[1] : low[1],
                              (corner & 4) != 0 ? high[2] : low[2]});
  }
  constexpr std::array<Triangle, 12> faces{{{0, 2, 1},
                                            {1, 2, 3},
                                            {4, 5, 6},
                                            {5, 7, 6},
                                            {0, 1, 4},
                                            {1, 5, 4},
                                            {2, 6, 3},
                                            {3, 6, 7},
                                            {0, 4, 2},
                                            {2, 4, 6},
                                            {1, 3, 5},
                                            {3, 7, 5}}};
  for (const Triangle& t : faces) {
    surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

/** \brief A chair, mirrored in x = 0: seat, back, four legs and two arm rests, which overlap; 64 corners. */
inline Surface
chairOfBoxes()
{
  Surface chair;
  addBox(chair, {-0.25F, -0.25F, 0.43F}, {0.25F, 0.25F, 0.48F});
  addBox(chair, {-0.25F, 0.21F, 0.47F}, {0.25F, 0.25F, 1.0F});
  for (const float side : {-1.0F, 1.0F}) {
    for (const float y : {-0.24F, 0.2F}) {
      const float x = side < 0.0F ? -0.24F : 0.2F;
      addBox(chair, {x, y, 0.0F}, {x + 0.04F, y + 0.04F, 0.44F});
    }
    const float x = side < 0.0F ? -0.27F : 0.23F;
    addBox(chair, {x, -0.22F, 0.47F}, {x + 0.04F, 0.23F, 0.7F});
  }
  return chair;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
