/** \file
 * \brief From what a sensor delivers to a cloud that a surface can be built on: without outliers, thin, not too large.
 */
#pragma once

#include "geodesic/neighbour_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A few points of a cloud that stand for all of it. */
struct ResampledCloud {
  std::vector<Vector3> points;        ///< moved onto the surface where the cloud is thick with noise
  std::vector<Index> original;        ///< point of the cloud that each of them was
  std::vector<Index> representatives; ///< for every point of the cloud the working point nearest to it; -1: an outlier
  /** Of the points, unit length; empty unless merged sheets were parted. */
  std::vector<Vector3> normals;
  std::vector<char> is_oriented; ///< whether a normal is known to point outwards, or into the other body in contact
  float smoothing_radius = 0.0F; ///< of the planes that noise was smoothed by; 0: the cloud was thin already
};

/** \brief How layers of points are read; without noise the first two are the same. */
enum class NoiseInterpretation {
  Smooth, ///< with neighbourhoods as large as the curvature allows: the best view of a surface that touches nothing
  Close,  ///< with as small ones as the noise allows: parts that nearly touch stay apart
  Parted  ///< close, and a layer of points with no outside on either side is two sheets in contact, with a point each
};

/** \brief Prepares a cloud.
 *
 * Outliers, see findOutliers (), are left out, unless they are hardly farther from a point in use than that is from
 * its neighbours. A cloud is thick where, at the distance of its neighbours, it fills space instead of a plane;
 * then points are moved onto planes fitted to the points within a larger radius, about the one at which most
 * neighbourhoods are flattest. Only points on the same sheet of the surface take part (robust moving least squares
 * \cite fleishman2005robust), so that the two sides of a thin part and two parts in contact stay apart as long as the
 * noise leaves a gap between them. Thick and large clouds are thinned out to an even spacing. A cloud so coarse that
 * its neighbourhoods are as large as limbs is left as it is, and so are points that fill space as a ball does: fitted to
 * them, planes would make up sheets.
 *
 * \param[in] points all finite, at unit scale
 * \param[in] lists their nearest neighbours
 * \param[in] maximum_points how many points may be left
 * \param[in] interpretation of the layers of points; sheets can only be parted where the surface is closed but for
 * small holes
 */
ResampledCloud
resampleCloud(const std::vector<Vector3>& points,
              const NeighbourLists& lists,
              std::size_t maximum_points,
              NoiseInterpretation interpretation = NoiseInterpretation::Smooth);

} // namespace symmetry
} // namespace pcl
