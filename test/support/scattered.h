/** \file
 * \brief Clouds of points at random places of a mesh.
 */
#pragma once

#include "base/vector_math.h"

#include <pcl/symmetry/surface.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Points at random places, as many on each area as on any other of its size. */
inline Surface
scattered(const Surface& mesh, std::size_t count)
{
  std::vector<float> areas;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& a = mesh.points[t[0]];
    areas.push_back(norm(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a)));
  }
  std::mt19937_64 random(1);
  std::discrete_distribution<std::size_t> face(areas.begin(), areas.end());
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  Surface cloud;
  while (cloud.size() < count) {
    const Triangle& t = mesh.triangles[face(random)];
    const float u = std::sqrt(share(random));
    const float v = share(random);
    cloud.points.push_back((1.0F - u) * mesh.points[t[0]] + u * (1.0F - v) * mesh.points[t[1]] +
                           u * v * mesh.points[t[2]]);
  }
  return cloud;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
