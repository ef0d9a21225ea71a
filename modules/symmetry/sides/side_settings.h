/** \file
 * \brief The numbers that decide sides, axis, limbs and measures of a map, together in one place.
 *
 * Origin of all of them unless another is given: chosen by hand on generated bodies and scans; not fitted by a script.
 */
#pragma once

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief The side of every vertex, see sides.h. */
struct SideSettings {
  /** Weight of the mean difference of distances beside the votes, which are whole numbers: geometric, below a half it
   * decides between equal votes and never against one. */
  float difference_weight = 0.49F;
  double speck_share = 0.02; ///< of the vertices, below which a patch of the other side is a speck
  int maximum_rounds = 16;   ///< specks within specks are rarely nested deeper than twice
};

/** \brief The sides of the samples, see sample_sides.h; chosen on TOSCA and generated bodies. */
struct SampleSideSettings {
  float landmark_blur = 4.0F;  ///< spacings by which the way over the surface to a partner is uncertain
  double adjacency = 0.02;     ///< how clearly adjacent samples are on one side, whatever the map says
  double minimum_degree = 1.0; ///< of a sample; six to eight are usual
  double shift = 1e-4;         ///< of the eigenvalues, which are 2e-4 to 1e-3 for the lowest
  double tolerance = 1e-3;     ///< change of the eigenvector in a round, of unit length
  int maximum_rounds = 30;     ///< usual are 5 to 10
};

/** \brief Sides grown from those that are clear, see side_growth.h; chosen on TOSCA. */
struct GrowthOfSidesSettings {
  float clear = 0.8F;   ///< of a side function of unit mean square, about 1 away from the axis
  float denied = 0.25F; ///< share of its way that a point counts with for the side that its sign denies
};

/** \brief Polylines of the axis, see axis_curve.h and curve_thinning.h.
 *
 * Radii are in half widths of the band, which is about the reach of a vertex's neighbours: a tube around a path that is
 * not quite in the middle has to cover the whole width, and the free ball around an end has to be larger than the tube.
 */
struct AxisSettings {
  double shortest_share = 0.05;    ///< of the longest line, below which one is left out
  std::ptrdiff_t longest_loop = 8; ///< vertices of a loop that is straightened out
  float tube_radius = 2.5F;        ///< above 2
  float end_radius = 4.0F;         ///< above the radius of the tube
  std::size_t maximum_curves = 32; ///< what is left by then are crumbs
};

/** \brief Limbs, see limb_regions.h. */
struct LimbSettings {
  float separation = 0.15F; ///< share of the diameter; nearer extremities belong to one limb, or to none
  std::size_t pairs = 2;    ///< the paper's
};

/** \brief Measures of a finished map, see map_quality.h; lengths are shares of the diameter. */
struct QualitySettings {
  float involution_tolerance = 0.02F; ///< within which a point counts as come back
  /** Change of the length of a side of a face above which the face is torn, share of the diameter, and of the length
   * itself: more than the images of its ends can be off by, which are vertices. Chosen by hand. */
  float torn_side = 0.05F;
  float torn_share = 0.33F;
  std::size_t landmarks = 16; ///< that distances are compared between
};

} // namespace symmetry
} // namespace pcl
