/** \file
 * \brief Ends of a body that a map leaves turned about their axis.
 */
#pragma once

#include "symmetry/refine/patch_fitting.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Turns the images of ends (heads, hands, tails) about their axes where that makes them fit.
 *
 * What lies behind a thin, round neck is joined to the rest by little that tells how it is turned about the neck, and
 * alignment of patches, which only goes downhill, does not find its way from a cheek to the nose. Here a reflection is
 * fitted to each end and its image, and again from several turns about its axis (the line from the middle of the end to
 * its tip); the best of them replaces the map there if it is clearly better.
 * \param[in] fitting of the samples in \a coarse
 * \param[in] tips samples at the ends
 * \param[in] radius geodesic, of an end around its tip
 * \param[in] partners partner point of every sample; corrected in place
 * \return number of ends that were turned */
std::size_t
turnParts(const PreparedSurface& surface,
          const CoarseSurface& coarse,
          const PatchFitting& fitting,
          const std::vector<Index>& tips,
          float radius,
          std::vector<Index>& partners,
          unsigned threads);

} // namespace symmetry
} // namespace pcl
