/** \file
 * \brief Planes that a surface is its own mirror image in, as it stands in space.
 */
#pragma once

#include "symmetry/mirror/area_samples.h"
#include "symmetry/mirror/plane_reflection.h"
#include "symmetry/surface/prepared_surface.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Settings of the search for mirror planes; lengths are shares of the diagonal of the bounding box.
 *
 * Origin: the tolerance and the least share are what the verdict "symmetric" of a set of public objects is defined by, and
 * were checked on that set alone; the others were set by hand before anything was run, and are not fitted. What equal planes
 * may differ by is what the facets of bodies of revolution make of planes that are equal on the body. */
struct PlaneSearchSettings {
  std::size_t directions = 600; ///< of normals over half a sphere: 6 degrees apart, what the alignment reaches over
  std::size_t aligned = 12;     ///< of the best directions, each better than those around it: a cube has nine planes
  float distinct = 0.15F;       ///< radians between the normals of distinct planes
  float hopeless = 0.04F;       ///< mean distance of the images from the surface above which nothing is aligned
  int rounds = 12;              ///< of the alignment
  float tolerance = 0.005F;     ///< within which an image lies on the surface
  float promising_share = 0.6F; ///< of the area after the first alignment; what fits less is given up
  float good_share = 0.99F;     ///< below which the alignment is repeated with the surface between the points
  float least_share = 0.95F;    ///< of the area that must come to lie on the surface: the rest is worn or fitted on
  float equal_residual = 0.1F;  ///< tolerances by which the mean distances of planes that fit equally well differ,
  float equal_share = 0.005F;   ///< and the same of the shares of the area
  /** Tolerances by which what lies on the surface is off it on average, at most, in a plane of a part. By hand, set once
   * between what was seen of mirrored halves, 0.001 to 0.03, and of what only stands nearly so, 0.2 and more; rigid parts of
   * a posed animal have 0.03 as well. 0: none is found. */
  float exact_residual = 0.1F;
  float least_displacement = 0.02F; ///< mean distance from the plane: a sheet lies in its own plane and maps to itself
};

/** \brief A plane, and how well the surface is its own mirror image in it. */
struct MirrorFit {
  PlaneReflection plane;
  float share = 0.0F;        ///< of the area whose image lies on the surface, within the tolerance
  float residual = 0.0F;     ///< mean distance of the images from the surface, cut at the tolerance
  float displacement = 0.0F; ///< mean distance from the plane
  bool is_equal = false;     ///< it fits as well as the plane that fits best
  bool is_of_part = false;   ///< more than a twentieth of the area has no counterpart, the rest exactly
};

/** \brief Planes in which the surface is its own mirror image but for a twentieth of its area, the best first; where there
 * is none, the plane in which most of it is so exactly, of the promising share at least, if there is one.
 *
 * What is the same in a plane to a fraction of the tolerance was made so, and what is beside it was fitted on, or is a posed
 * limb. Flat faces lie on themselves in any plane across them, so that this says little of a sheet.
 *
 * Of several that fit equally well the first is the one that most of the surface is far from, which swaps the ends of
 * what is long: that follows from the shape, and not from the order of its points or the axes of a file.
 *
 * The mirror plane of a body goes through its centroid: planes through it in all directions are compared by a distance
 * field on a grid (P. Felzenszwalb, D. Huttenlocher, 2012 \cite felzenszwalb2012distance), the best are aligned as by
 * iterated closest points (Y. Chen, G. Medioni, 1992 \cite chen1992modelling) with the weights of a robust estimator,
 * since some parts may lack a counterpart. Where none of them carries a cloud or a mesh in several parts as a whole onto
 * itself, planes beside the centroid are tried as well, which an odd part pulls towards it.
 *
 * \param[in] samples of the surface
 */
std::vector<MirrorFit>
findMirrorPlanes(const AreaSamples& samples, const PreparedSurface& surface, const PlaneSearchSettings& settings);

} // namespace symmetry
} // namespace pcl
