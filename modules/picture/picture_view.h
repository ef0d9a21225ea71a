/** \file
 * \brief Where a picture of a surface is seen from.
 */
#pragma once

#include "picture/rasterizer.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

namespace pcl {
namespace symmetry {

/** \brief Orthographic view: three orthonormal directions and what part of space the picture shows. */
struct PictureView {
  Vector3 right = {1.0F, 0.0F, 0.0F};
  Vector3 up = {0.0F, 1.0F, 0.0F};
  Vector3 toward = {0.0F, 0.0F, 1.0F}; ///< from the surface to the viewer
  Vector3 centre = {0.0F, 0.0F, 0.0F};
  float width = 1.0F; ///< of what is shown, in the unit of the points
  float height = 1.0F;

  /** \brief The same from behind, turned about \a up. */
  PictureView
  fromBehind() const;
};

/** \brief A pair of partners to draw a line between. */
struct PartnerPair {
  Index source = no_index;
  Index target = no_index;
};

/** \brief All pairs of the dense map from source to target side; those of the sparse matches where there is no dense
 * map. */
std::vector<PartnerPair>
findPartnerPairs(const Surface& surface, const SymmetryResult& result);

/** \brief Looks at both sides at once, from where as much as possible of each can be seen, with the line from side to
 * side level. What stands upright (upright.h) is drawn so; at a surface without pairs it looks from where most can be
 * seen. */
PictureView
chooseView(const Surface& surface, const SymmetryResult& result, const std::vector<PartnerPair>& pairs);

} // namespace symmetry
} // namespace pcl
