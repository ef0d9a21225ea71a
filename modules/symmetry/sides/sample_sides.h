/** \file
 * \brief The sides of the samples under a map.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Which side each sample is on: the function that a map turns over and that changes least.
 *
 * Two samples close together are on one side if they are nearer to each other than to each other's partners, else on
 * opposite ones; on the axis they are as near to both, which says nothing. These relations make a signed graph, weighted
 * by how clear they are and by how nearly the partner of a partner is the sample itself. The lowest eigenvector of its
 * normalized Laplacian (J. Kunegis et al.: Spectral analysis of signed graphs for clustering, prediction and
 * visualization, 2010 \cite kunegis2010spectral) agrees with most of them. A part is related to the rest along its whole
 * girth but across the axis hardly at all: sides do not swap at a waist, and are as clear on a thin limb as in the bulk.
 * \param[in] partners point that is the partner of each sample
 * \return per sample, of unit mean square, positive on the side that chirality () names, or where that is zero at the
 * first sample that is far from its partner; near zero at the axis and where
 * the map says nothing; all zero where nothing moves. Cost that of factorizing a sparse matrix of the samples. */
std::vector<float>
sampleSides(const SampledSurface& sampled, const std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
