/** \file
 * \brief Noise of a point cloud, and moving its points onto the sheets of the surface.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How a noisy cloud is smoothed. */
struct Smoothing {
  float radius = 0.0F;       ///< of the neighbourhoods that sheets are fitted to; 0: there is no noise to speak of
  float least_radius = 0.0F; ///< of neighbourhoods with enough points for their planes to be certain
  float width = 0.0F;        ///< half the thickness of a sheet
  float spacing = 0.0F;      ///< of points that show all that is left to see
};

/** \brief The radius at which neighbourhoods are flattest for their size: below it noise makes them thick, above it
 * the curvature of the surface.
 *
 * None where they are flat at the spacing, or hardly thick there and, since that comes from curvature, thicker at once
 * above it. The width is that of the flattest neighbourhoods, which curvature makes thicker than the noise alone: a
 * narrower one would keep noise that happens to bunch.
 * \param[in] points at unit scale
 * \param[in] spacing mean distance to the neighbours */
Smoothing
findSmoothing(const std::vector<Vector3>& points, float spacing);

/** \brief The same with the smallest radius that still gives certain planes, wherever the points are dense enough: it
 * rounds off less of what is thin and of the seams along which parts touch, and leaves more noise.
 * \param[in] spacing mean distance of the points to their neighbours */
Smoothing
withLeastRadius(Smoothing smoothing, float spacing);

/** \brief Places on the sheets of a surface, and what is known of the sheets there. */
struct SheetPlaces {
  std::vector<Vector3> places;
  std::vector<Vector3> normals; ///< unit length, of either sign
  std::vector<float> gaps;      ///< distance between the points of the cloud there
  /** How many points within the radius are on the sheet, 0 where most points around are on others. */
  std::vector<float> support;
};

/** \brief Moves places onto the sheets of the surface around them.
 *
 * Where two sheets are nearer to each other than the radius each place stays with its own (robust moving least squares,
 * as S. Fleishman et al.: Robust moving least-squares fitting with sharp features, 2005
 * \cite fleishman2005robust).
 * \param[in] points of the cloud */
SheetPlaces
moveToSheets(std::vector<Vector3> places, const std::vector<Vector3>& points, const Smoothing& smoothing);

} // namespace symmetry
} // namespace pcl
