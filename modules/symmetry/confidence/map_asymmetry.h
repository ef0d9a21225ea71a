/** \file
 * \brief Measures of how far a surface is from a mirror image of itself in spite of a map that looks like a reflection.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/search/functional_map.h"

#include <Eigen/Core>

namespace pcl {
namespace symmetry {

/** \brief Where one side has a part that the other lacks, a map stretches the surface in one place and keeps it
 * everywhere else, so it is the worst places that are looked at; means hardly notice. */
struct AsymmetryMeasures {
  float concentration = 1.0F; ///< stretch of the map at the worst hundredth of the landmarks over the median stretch
  /** Change of the distances around a landmark, as a share of those distances, at the worst 3 % of the landmarks; after
   * the map has been relaxed: what a better map would not stretch does not count. */
  float stretch = 1.0F;
  float involution = 1.0F; ///< mean d (i, m (m (i))) of the relaxed map, share of the diameter
  /** Change of the average distance to all landmarks from a landmark to its image, share of the diameter, at the worst
   * 3 % of the landmarks: what a pose changes in the large. */
  float average_distance = 1.0F;
  float curvature =
      2.0F; ///< mean squared difference of curvature around a landmark over its variance: the median landmark
};

/** \brief Cost: about that of scoring a few maps of all landmarks.
 * \param[in] curvature ShapeDescriptor::curvature; row i belongs to landmark i, further rows do not count */
AsymmetryMeasures
findAsymmetry(const LandmarkSurface& landmarks, const Eigen::MatrixXf& curvature, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
