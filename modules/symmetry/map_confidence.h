/** \file
 * \brief How far a map can be trusted: as a whole, and point by point.
 */
#pragma once

#include "symmetry/map_score.h"
#include "symmetry/sample_interpolation.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Confidence of a whole map in [0, 1]: a logistic function of its score. */
float
reflectionConfidence(const MapScore& score);

/** \brief Whether a map is good enough to be called a reflective symmetry. */
bool
isReflection(const MapScore& score);

/** \brief Share of the confidence of a map that its asymmetry leaves: a logistic function of asymmetry (). */
float
symmetryConfidence(float asymmetry);

/** \brief Whether one side of the surface has too much that the other lacks. */
bool
isAsymmetric(float asymmetry);

/** \brief Confidence of every point: that of the map, lowered where distances to other samples change.
 *
 * At sample i the mean change |d (i, j) - d (m (i), m (j))| over the hubs j, share of the diameter, divides the map's
 * confidence by 1 + (change / 5 %)^2.
 */
std::vector<float>
pointConfidences(const HubSurface& hubs,
                 const CoarseSurface& coarse,
                 const SampleMap& map,
                 const SampleInterpolation& interpolation,
                 float map_confidence);

} // namespace symmetry
} // namespace pcl
