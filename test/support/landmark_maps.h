/** \file
 * \brief Maps of landmarks that are known.
 */
#pragma once

#include "base/vector_math.h"
#include "symmetry/samples/landmark_surface.h"
#include "symmetry/samples/sample_map.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief The landmark nearest to the image of each landmark under a mapping of space that maps the surface to itself.
 */
template <typename Mapping>
SampleMap
mapOf(const LandmarkSurface& landmarks, Mapping mapping)
{
  SampleMap map;
  for (const Vector3& p : landmarks.points) {
    const Vector3 image = mapping(p);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < landmarks.size(); ++i) {
      if (distance(landmarks.points[i], image) < distance(landmarks.points[nearest], image)) {
        nearest = i;
      }
    }
    map.push_back(static_cast<Index>(nearest));
  }
  return map;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
