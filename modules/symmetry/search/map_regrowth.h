/** \file
 * \brief Parts of a map grown anew, where it is a reflection on most of a surface, but not on all of it.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/search/functional_map.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How far a map turns the surface over around every landmark: from -1 (nowhere, as a rotation) to 1
 * (everywhere).
 *
 * Mean over the triangles within two steps of the landmark, by area; an image counts by its own area, at most by that
 * of the original, so that the slivers that sampling noise turns over do not. 0 where there are no triangles.
 */
std::vector<float>
reversalAtLandmarks(const LandmarkSurface& landmarks, const SampleMap& map);

/** \brief Mean change of the distances to the landmarks around every landmark under a map, as a share of those
 * distances. */
std::vector<float>
stretchAtLandmarks(const LandmarkSurface& landmarks, const SampleMap& map);

/** \brief Places landmarks at which a map tears the surface (stretch more than twice the median) anew, each where its
 * distances to the landmarks around it come out best. Heals tears for which the surface gives no reason; where one side
 * has a part that the other lacks, what is gained nearby is lost in distances to all others or in the involution. */
SampleMap
relaxedMap(const LandmarkSurface& landmarks, const SampleMap& map);

/** \brief Moves the image of every landmark, in turn, to where its distances to the landmarks around it and to a few
 * landmarks all over the surface come out best, \a rounds times. */
SampleMap
refittedMap(const LandmarkSurface& landmarks, SampleMap map, int rounds);

/** \brief Derives a map anew wherever it keeps the orientation.
 *
 * The lowest eigenfunctions hardly see a part behind a thin neck (a head), so that a map may leave it as it is or turn
 * it while it mirrors all the rest. From what is sound around such a part, landmark after landmark is placed where its
 * distances to the landmarks around it that have a place already come out best; distances to a few sound landmarks all
 * over the surface keep the growing part from folding back. \return empty where there is nothing to grow anew, or not
 * enough to start from
 */
SampleMap
regrownMap(const LandmarkSurface& landmarks, const SampleMap& map);

} // namespace symmetry
} // namespace pcl
