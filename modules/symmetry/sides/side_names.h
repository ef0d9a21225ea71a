/** \file
 * \brief Which of the two sides is called the source side.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"
#include "symmetry/sides/side_settings.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A number whose sign tells the two sides of a surface apart, by its shape alone.
 *
 * Two functions g and h that a reflection keeps carry the axis curve to a loop in the plane of their values. Seen from
 * outside and with one side on the left, the loop is walked in one direction; with the other side on the left in the
 * other. So the area that it encloses with its sign is a chirality: of the side function u it is, by Stokes, half the
 * integral over the surface of h dg ^ du, and changes its sign with u. It depends neither on place, scale and
 * triangles nor, as far as g and h do not, on the pose: on one body the same side keeps its name.
 *
 * Two such areas are summed up: of mean distance and heat kernel signature (J. Sun et al.: A concise and provably
 * informative multi-scale signature based on heat diffusion, 2009 \cite sun2009concise), and of a finer signature and
 * curvature. On bodies whose front and back, or head and tail, hardly differ the sign is arbitrary.
 * \param[in] sides of the samples, of unit mean square
 * \return about 1 in size on bodies; positive on an upright human if the sides are positive on its left; zero where
 * nothing tells. Cost O(samples * landmarks) */
double
chirality(const SampledSurface& sampled, const std::vector<float>& sides, const SideNameSettings& settings = {});

} // namespace symmetry
} // namespace pcl
