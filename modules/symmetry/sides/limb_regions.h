/** \file
 * \brief Extremities in symmetric pairs and the regions around them, from a map of the landmarks.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/samples/sample_map.h"

#include <pcl/symmetry/symmetry_result.h>

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The two pairs of swapped extremities that are farthest apart, source side first; fewer where the surface has
 * fewer. \param[in] sides of the landmarks: negative on the target side */
std::vector<std::pair<Index, Index>>
swappedExtremities(const LandmarkSurface& landmarks, const SampleMap& map, const std::vector<float>& sides);

/** \brief Region of every landmark: limb of a pair where the landmark is nearer to its extremity than half the way
 * to the other one, else centre (as the regions of the staged method). */
std::vector<Region>
limbRegions(const LandmarkSurface& landmarks, const std::vector<std::pair<Index, Index>>& limbs);

} // namespace symmetry
} // namespace pcl
