/** \file
 * \brief From a map of the samples to a map of every point.
 */
#pragma once

#include "symmetry/samples/sample_map.h"
#include "symmetry/samples/sampled_surface.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Partner point of every sample, to the precision of the surface instead of that of the samples.
 *
 * Searched by eigenfunctions among the points of the cells around the image of the sample.
 * \param[in] map partner sample of every sample
 * \param[in] matrix its action on the leading eigenfunctions
 */
std::vector<Index>
partnersOfSamples(const SampledSurface& sampled, const SampleMap& map, const Eigen::MatrixXf& matrix);

/** \brief Partners of the samples drawn towards a map that is its own inverse and smooth.
 *
 * In each round every sample goes to where its own match and those around it, read both ways, put its partner.
 * \param[in] sample_partners partner point of every sample */
std::vector<Index>
mutualPartners(const SampledSurface& sampled, std::vector<Index> sample_partners, int rounds);

/** \brief Partner of every point: where the matches of the samples around it put it, the nearest point of the surface.
 * Smooth wherever the partners of the samples are. */
std::vector<Index>
partnersOfPoints(const SampledSurface& sampled, const std::vector<Index>& sample_partners);

} // namespace symmetry
} // namespace pcl
