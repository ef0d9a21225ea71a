/** \file
 * \brief Splits long sides of triangles, so that a mesh has points wherever it has surface.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief A mesh gets points at least as close together as so many are on a surface: four for each of 1,500 samples,
 * so that a cell between samples has a shape. */
constexpr std::size_t points_of_a_surface = 6000;

/** \brief Distance of neighbours where so many points are spread over the area of a mesh in equilateral triangles; 0
 * without area. */
float
evenSpacing(const PreparedSurface& surface, std::size_t points);

/** \brief Splits long sides of triangles in their middles: a box of eight corners becomes a surface along which distances
 * can be told, samples be taken and parts be linked where they touch.
 *
 * A mesh in several parts or with fewer than half of the points that are \a wanted (two for each sample) is split until
 * no side is longer than what so many points, spread evenly over the area, are apart. Any other stays as it is but for
 * sides several times as long: a few split sides among others shorten ways on one side of a body and not on the other.
 * Nor is one of fewer than 60 points split, in several parts of fewer than 16: what has hardly a shape is not made to look
 * as if it had.
 *
 * The splitting ends early where it would make more than four times the wanted points, of slivers.
 *
 * A new point stands for no point of the input; what is found there is told of the nearest of the points that its side
 * is between.
 * \param[in,out] surface a mesh; its normals are not brought along
 * \return number of points added */
std::size_t
splitLongSides(PreparedSurface& surface, std::size_t wanted);

} // namespace symmetry
} // namespace pcl
