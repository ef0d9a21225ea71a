/** \file
 * \brief What every method starts from: the usable part of a surface, at unit scale, with its graph.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <pcl/symmetry/symmetry_result.h>

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The largest object among the finite points of a surface: one component, or several that belong together.
 *
 * Points are moved and scaled so that the bounding box (of a mesh: of its largest component; of a cloud: without parts
 * farther away than the largest is long) is centred at the origin and its longest side is 1: whatever the unit of the
 * input, floats neither overflow nor underflow. Point i here is point \a original[i] of the input; the order is kept.
 */
struct PreparedSurface {
  std::vector<Vector3> points;
  std::vector<Triangle> triangles; ///< without degenerate and repeated ones; of a cloud: local Delaunay triangles
  /** The triangles before long sides were split, by which a map is judged; empty where none were. */
  std::vector<Triangle> unsplit;
  bool is_cloud = false;        ///< faces of the input, if any, were not used: triangles are no manifold
  std::vector<Vector3> normals; ///< consistently oriented (outward or inward), unit length
  SurfaceGraph graph;           ///< mesh edges, or a neighbour graph of the cloud, and links between parts
  std::vector<Index> part_of;   ///< number of the part that each point is of; empty where there is one part
  std::vector<Index> original;  ///< input index of each point, or of one near by where there is none
  /** For each input point the point here that stands for it, no_index where it was left out. Several may share one: a
   * noisy or very large cloud is solved on a thinned-out one. */
  std::vector<Index> representatives;
  float scale = 1.0F;             ///< length here = scale * length in the input
  std::array<double, 3> centre{}; ///< place here = scale * (place in the input - centre)
  InputSummary summary;

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief Keeps the points with a true entry in \a keep, in order, and what refers to them, but for the graph. */
void
keepPoints(PreparedSurface& surface, const std::vector<char>& keep);

/** \brief Input points for which no point of the surface stands. */
std::size_t
countLeftOut(const PreparedSurface& surface);

} // namespace symmetry
} // namespace pcl
