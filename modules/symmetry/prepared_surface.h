/** \file
 * \brief What every method starts from: the usable part of a surface, at unit scale, with its graph.
 */
#pragma once

#include "cloud/cloud_surface.h"
#include "cloud/working_cloud.h"
#include "geodesic/neighbour_graph.h"
#include "geodesic/surface_graph.h"

#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The largest component of the finite points of a surface.
 *
 * Points are moved and scaled so that the bounding box (of a mesh: of its faces) is centred at the origin and its
 * longest side is 1: whatever the unit of the input, floats neither overflow nor underflow. Point i here is point \a
 * original[i] of the input; the order is kept.
 */
struct PreparedSurface {
  std::vector<Vector3> points;
  std::vector<Triangle> triangles; ///< without degenerate and repeated ones; of a cloud: local Delaunay triangles
  bool is_cloud = false;           ///< the input had no faces: triangles are no manifold
  std::vector<Vector3> normals;    ///< consistently oriented (outward or inward), unit length
  SurfaceGraph graph;              ///< mesh edges, or a neighbour graph of the cloud
  std::vector<Index> original;     ///< input index of each point
  /** For each input point the point here that stands for it, no_index where it was left out. Several may share one: a
   * noisy or very large cloud is solved on a thinned-out one. */
  std::vector<Index> representatives;
  float scale = 1.0F; ///< length here = scale * length in the input
  InputSummary summary;

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief What does not depend on how the contacts of a cloud are read. */
struct UsablePoints {
  PreparedSurface surface;       ///< without graph; of a cloud also without triangles, and with given normals only
  NeighbourLists neighbours;     ///< of a cloud
  std::vector<char> is_oriented; ///< see WorkingCloud; where empty, normals are oriented all or there are none
};

/** \brief Drops what cannot be used and normalises the rest; goes over to the working points of a cloud.
 * \param[in] surface the input; triangle indices must be in range
 * \param[in] search nearest-neighbour search; used for clouds only
 * \param[in] reading see makeWorkingCloud ()
 */
UsablePoints
usablePoints(const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             NoiseReading reading = NoiseReading::Smooth);

/** \brief Builds the graph and restricts the surface to its largest component.
 * \param[in] contact how readily edges of a cloud are taken for shortcuts
 */
PreparedSurface
prepareSurface(UsablePoints usable, const SymmetryParameters& parameters, const ContactTest& contact);

/** \brief Both steps at once. */
PreparedSurface
prepareSurface(const Surface& surface,
               const SymmetryParameters& parameters,
               const NeighbourSearch& search,
               const ContactTest& contact = {});

} // namespace symmetry
} // namespace pcl
