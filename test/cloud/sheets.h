/** \file
 * \brief Sheets and cubes as clouds, and the surfaces of clouds as the tests build them.
 */
#pragma once

#include "cloud/cloud_surface.h"
#include "cloud/clouds.h"

namespace pcl {
namespace symmetry {
namespace test {

inline CloudSurface
surfaceOf(const std::vector<Vector3>& points, const ContactTest& contact = {})
{
  return buildCloudSurface(points, nearestNeighbours(points, 10), {}, 0.0F, contact);
}

inline SurfaceGraph
plainGraph(const std::vector<Vector3>& points)
{
  return buildNeighbourGraph(points, nearestNeighbours(points, 10), 0.0F);
}

inline Index
nearestTo(const std::vector<Vector3>& points, const Vector3& place)
{
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vector3& a, const Vector3& b) {
    return distance(a, place) < distance(b, place);
  });
  return static_cast<Index>(nearest - points.begin());
}

/** \brief Square of side 1 at a height, irregularly sampled n by n times. */
inline std::vector<Vector3>
sheet(int n, float height, unsigned seed)
{
  std::mt19937 random(seed);
  const float spacing = 1.0F / static_cast<float>(n);
  std::vector<Vector3> points;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      points.push_back({spacing * (static_cast<float>(i) + evenly(random, 0.3F, 0.7F)),
                        spacing * (static_cast<float>(j) + evenly(random, 0.3F, 0.7F)), height});
    }
  }
  return points;
}

/** \brief Surface of the cube of side 1 around the origin, irregularly sampled. */
inline std::vector<Vector3>
cubeCloud(int n, unsigned seed)
{
  std::vector<Vector3> points;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5F, 0.5F}) {
      for (const Vector3& p : sheet(n, side, seed++)) {
        Vector3 q;
        q[axis] = side;
        q[(axis + 1) % 3] = p[0] - 0.5F;
        q[(axis + 2) % 3] = p[1] - 0.5F;
        points.push_back(q);
      }
    }
  }
  return points;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
