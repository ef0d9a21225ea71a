/** \file
 * \brief The numbers that decide how a surface is sampled and described, together in one place.
 *
 * Origin of all of them unless another is given: chosen by hand on generated bodies and scans; not fitted by a script.
 * The number of samples and landmarks is for the caller to say.
 */
#pragma once

#include <array>
#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Flow between cells, see coarse_surface.h. */
struct CellSettings {
  float cotangent_bound = 5.0F;      ///< 11 degrees: slivers must not take over
  float minimum_conductance = 0.01F; ///< for a difference of 1; keeps connected what is connected
};

/** \brief What is a hole, see hole_cells.h. */
struct HoleSettings {
  float mesh_crack = 2.0F;   ///< spacings of the samples; a shorter rim is a crack
  float cloud_crack = 5.0F;  ///< the same: where parts of a cloud touch, edges are left out, and rims appear
  float whole_side = 0.3F;   ///< share of the longest side; a longer rim is the border of an open surface
  float rim_gap = 2.6F;      ///< radians without a neighbour, on a rim: geometric, almost half a turn
  float possible_gap = 2.0F; ///< radians, a third of a turn: where the rim bends inwards, but also at random
};

/** \brief Moving least squares between samples, see sample_interpolation.h. */
struct InterpolationSettings {
  float falloff = 2.0F;  ///< of the weight exp (-falloff (d / spacing)^2) of a sample
  float damping = 0.02F; ///< share of the sum of the weights that is added to the second moments
};

/** \brief Parts of the descriptor, see shape_descriptor.h; DescriptorWeights has their weights. */
struct DescriptorSettings {
  float row_floor = 0.3F;                 ///< mean lengths of a row: keeps small features small when rows are scaled
  std::array<int, 3> smoothing{2, 6, 16}; ///< rounds at which the height over the smoothed surface is taken, rising
};

/** \brief Landmarks that stand out, and those that say something, see landmark_surface.h. */
struct LandmarkSettings {
  float separation = 1.0F / 15.0F;      ///< share of the diameter within which an extremity is the farthest out
  std::size_t maximum_extremities = 10; ///< the farthest out
  std::size_t comparable_part = 5;      ///< one of so many must be away from holes, else all count
};

/** \brief The step in which matches slide along the surface, see rigid_reflection.h. */
struct SlideSettings {
  float stiffness = 0.1F;     ///< weight of staying in place over that of the planes; above 0
  float maximum_angle = 1.0F; ///< radians: geometric, beyond it the linearisation means nothing
};

} // namespace symmetry
} // namespace pcl
