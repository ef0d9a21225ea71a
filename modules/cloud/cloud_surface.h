/** \file
 * \brief From a point cloud to a surface: a graph that resists shortcuts between parts in contact, normals, triangles.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "geodesic/surface_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What a mesh has and a cloud has not. */
struct CloudSurface {
  SurfaceGraph graph;
  std::vector<Vector3> normals; ///< unit length, consistently oriented
  std::vector<Triangle> triangles;
  std::size_t distrusted_edges = 0; ///< edges left out as shortcuts
  std::size_t bridges = 0;          ///< edges put in to join what fell apart without them
};

/** \brief What is taken for a shortcut between parts in contact. Where parts touch, points of both lie closer together
 * than the spacing and normals turn from one part to the other in a few steps; on a thin or sharp part they do so as
 * well. How far to go is for the caller to try. */
struct ContactTest {
  float bend = 0.5F;   ///< least cosine between the normals at the ends of an edge that is trusted
  float detour = 3.0F; ///< a distrusted edge is kept if the way round it is at most so many times as long
  /** How far, in spacings, an edge is moved into the body to see whether it meets a surface there, and then is no
   * longer trusted; 0: not at all. Tells contacts in a noisy cloud, where touching surfaces have merged, and leaves
   * thin parts with few edges. */
  float depth = 0.0F;
  /** Whether estimated normals are those of one sheet (sheet_normals.h), for points without noise: edges between two
   * sheets bend more, and so do those of thin parts. */
  bool sheet_normals = false;
  /** Largest sine of the angle, the mean of both ends, at which a trusted edge leaves the tangent planes of its ends to
   * the same side, as it does between two parallel sheets even if the normals of one are turned the wrong way; on a
   * bend of one sheet it leaves them to opposite sides. At least five times the median of all edges. */
  float step = 1.0F;

  bool
  operator==(const ContactTest& other) const
  {
    return bend == other.bend && detour == other.detour && depth == other.depth &&
           sheet_normals == other.sheet_normals && step == other.step;
  }
};

/** \brief Builds graph, normals and triangles of a cloud.
 *
 * An edge of the k-nearest-neighbour graph is distrusted where it runs along a normal instead of along the surface
 * (it leads to another part in contact), or from one sheet to a parallel one, or where the oriented normals at its ends
 * differ much, unless the way along trusted edges is hardly longer. Parts that the plain graph joins and the remaining
 * one does not are joined again by their shortest distrusted edges; parts that even the plain graph leaves apart, by
 * links across the gap between them.
 *
 * \param[in] points all finite
 *
 * \param[in] lists k nearest neighbours
 *
 * \param[in] given_normals used instead of estimated ones; may be empty
 *
 * \param[in] radius longest edge, 0: no limit
 *
 * \param[in] is_oriented which of the given normals are turned the right way, the others are turned to agree with them;
 * empty: all
 */
CloudSurface
buildCloudSurface(const std::vector<Vector3>& points,
                  const NeighbourLists& lists,
                  const std::vector<Vector3>& given_normals,
                  float radius,
                  const ContactTest& contact,
                  const std::vector<char>& is_oriented = {});

} // namespace symmetry
} // namespace pcl
