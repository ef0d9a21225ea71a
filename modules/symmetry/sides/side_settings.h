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

/** \brief Names of the sides, see side_names.h: chosen on 54 poses of TOSCA, KIDS and posed human bodies, where those of
 * people all agree, and on generated bodies. */
struct SideNameSettings {
  double short_time = 0.01; ///< of heat, on a surface of area 1
  double long_time = 0.03;
  std::ptrdiff_t curvature_scale = 1; ///< the middle one of three
  double distance_unit = 0.65;        ///< medians of the two areas
  double curvature_unit = 4.7;
  double clear = 0.8; ///< of a side function of unit mean square, about 1 away from the axis
};

/** \brief Sides grown from those that are clear, see side_growth.h; chosen on TOSCA. */
struct GrowthOfSidesSettings {
  float clear = 0.8F;   ///< of a side function of unit mean square, about 1 away from the axis
  float denied = 0.25F; ///< share of its way that a point counts with for the side that its sign denies
};

/** \brief The smooth side function, see axis_smoothing.h; chosen on generated bodies and scans. */
struct AxisSmoothingSettings {
  float edges = 1.0F;    ///< standard deviation of the flow in edges, at least: what points resolve
  float share = 0.004F;  ///< and as a share of the longest side of the box
  float reach = 4.0F;    ///< of the band around the axis, in deviations
  int steps = 2;         ///< more come closer to a Gaussian, which is not needed
  double thinnest = 1e3; ///< longest side of a triangle over its height, above which it is a sliver
};

/** \brief Polylines of the axis, see axis_curve.h and curve_points.h. */
struct AxisSettings {
  float shortest_share = 0.05F;    ///< of the longest line, below which one is left out
  std::ptrdiff_t longest_loop = 8; ///< points of a loop that is straightened out
  std::size_t most_stretches = 32; ///< of a cloud, that are joined: each pair of ends is a question
  float coincidence = 0.1F;        ///< of an edge, below which two crossings are one place
  /** Taubin's two steps: what they let through undamped is longer than 30 places. */
  float fairing = 0.5F;
  float fairing_back = 0.51F;
  int fairing_rounds = 6;
};

/** \brief Gaps in the lines of a cloud, see line_joining.h; chosen on clouds of generated bodies and scans. */
struct LineJoiningSettings {
  float widest = 0.15F;       ///< gap, as a share of the longest side of the box
  float widest_share = 0.25F; ///< gap between the two ends of one line, as a share of its length
  float least = 0.01F;        ///< gap that is none; added to the width of others, as their ends are not on the zero
  float detour = 3.0F;        ///< length of the path over that width
  float stray = 1.0F;         ///< way of a point on it to its partner, over that width
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
