/** \file
 * \brief Extremities that a map leaves turned about their axis.
 */
#pragma once

#include "symmetry/refine/patch_fitting.h"
#include "symmetry/samples/sampled_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Turns the images of extremities (heads, hands, tails) about their axes where that makes them fit.
 *
 * What lies behind a thin, round neck is joined to the rest by little that tells how it is turned about the neck, and
 * alignment of patches, which only goes downhill, does not find its way from a cheek to the nose. Here a reflection is
 * fitted to each extremity and its image, and again from several turns about its axis (the line from the middle of the
 * patch to its extreme point); the best of them replaces the map there if it is clearly better.
 * \param[in] fitting of the samples
 * \param[in] extremities samples that are the extreme points
 * \param[in] radius geodesic, of the patch around an extreme point
 * \param[in] partners partner point of every sample; corrected in place
 * \return number of extremities that were turned */
std::size_t
rotateExtremities(const SampledSurface& sampled,
                  const PatchFitting& fitting,
                  const std::vector<Index>& extremities,
                  float radius,
                  std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
