/** \file
 * \brief How good a map of the landmarks is as a reflective symmetry of the surface.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/search/functional_map.h"

namespace pcl {
namespace symmetry {

/** \brief Measures of a map m, lengths as shares of the diameter; the lower \a value the better. */
struct MapScore {
  float isometry = 1.0F;     ///< mean |d (i, j) - d (m (i), m (j))|
  float involution = 1.0F;   ///< mean d (i, m (m (i)))
  float displacement = 0.0F; ///< mean d (i, m (i))
  /** Mean of log (d (i, m (i)) + ScoreWeights::resolution), as far as d is at most a fifth; at first that of nobody moving.
   * Where an image is near, distances change little, whether
   * the map is right or not: a limb that is mirrored in itself fits without effort. What moves far does not make up for it,
   * as in \a displacement, and how far beyond a fifth tells nothing: head to tail is farther than left to right. */
  float log_displacement = -6.2F;
  float nearest_image = 1.0F; ///< d (i, m (i)) of the 2 % that move least: near 0 where the map has an axis
  float fixed = 1.0F;         ///< share of landmarks that move less than 6 %
  float reversal = 0.0F;      ///< share of the area that is turned over: near 1 for a reflection, 0 for a rotation
  float curvature = 2.0F;     ///< mean squared difference of the standardized curvatures of a landmark and its partner
  float distorted = 1.0F;     ///< share of landmarks whose distances to the others change by more than 8 % on average
  float value = 1e9F;
};

/** \brief MapScore::nearest_image of a map with an axis, at most: landmarks are a few hundredths of the diameter apart, and the
 * axis runs between them. */
constexpr float axis_reach = 0.1F;

/** \brief Weights of the measures in MapScore::value. */
struct ScoreWeights {
  float resolution = 2e-3F; ///< displacement that cannot be told from none, share of the diameter
  float displacement = 0.8F;
  float reversal = 2.0F;
  float fixed = 3.0F;
  float curvature = 0.6F;
  /** Of what a reflection's nearest image is beyond axis_reach: what has no axis is no reflection (none of 215 maps without one
   * was right), but moves all of the surface. Anything from 5 to 20 is the same. */
  float axis = 10.0F;
};

/** \param[in] descriptor of all samples, for the curvature
 * \param[in] queries how many landmarks take part in the measure of isometry */
MapScore
scoreMap(const LandmarkSurface& landmarks,
         const ShapeDescriptor& descriptor,
         const SampleMap& map,
         std::size_t queries,
         const ScoreWeights& weights);

/** \brief As scoreMap (), of a map that is to keep the orientation: a rotation.
 *
 * A rotation need not be its own inverse: \a involution is the mean d (i, inverse (m (i))), and a large \a reversal
 * counts against it. */
MapScore
scoreRotation(const LandmarkSurface& landmarks,
              const ShapeDescriptor& descriptor,
              const SampleMap& map,
              const SampleMap& inverse,
              const ScoreWeights& weights);

/** \brief Whether a map sends a landmark farther away than \a far (share of the diameter), and from there back to it or to a
 * landmark beside it. */
bool
isExchanged(const LandmarkSurface& landmarks, const SampleMap& map, Index landmark, float far);

/** \brief Mean distance between the images of two maps, share of the diameter. */
float
mapDifference(const LandmarkSurface& landmarks, const SampleMap& a, const SampleMap& b);

} // namespace symmetry
} // namespace pcl
