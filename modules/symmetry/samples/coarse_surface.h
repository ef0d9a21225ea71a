/** \file
 * \brief A coarse stand-in for a surface: farthest-point samples, joined where their Voronoi cells meet.
 */
#pragma once

#include "geodesic/farthest_point_sampling.h"
#include "symmetry/surface/prepared_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Triangulated samples of a surface; numbers of samples are used throughout, not of points. */
struct CoarseSurface {
  FarthestPointSamples cells;      ///< samples and the cell each point belongs to
  std::vector<Vector3> points;     ///< position of each sample
  std::vector<Vector3> normals;    ///< mean normal of its cell, unit length
  std::vector<float> areas;        ///< of the cells; they sum up to 1
  std::vector<Triangle> triangles; ///< dual of the cells, oriented as the surface
  SurfaceGraph graph;              ///< adjacency of the cells with geodesic lengths
  std::vector<float> conductances; ///< per edge of the graph: flow between two cells for a difference of 1
  std::vector<char> at_hole;       ///< not 0: a hole reaches into the cell, see cellsAtHoles ()

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief Samples a surface evenly and triangulates the samples.
 *
 * Wherever three cells meet in a triangle of the surface, their samples form a coarse triangle; a cloud's samples are
 * triangulated by local Delaunay triangulations in their tangent planes instead. The first sample is the point farthest
 * from the centroid, so that the samples do not depend on the order of the points.
 */
CoarseSurface
coarsenSurface(const PreparedSurface& surface, std::size_t samples);

/** \brief Mean distance between adjacent samples; 0 where there is only one. */
float
sampleSpacing(const CoarseSurface& coarse);

/** \brief Triangles between cells: one for every three cells that meet in a triangle, without duplicates.
 * \param[in] triangles of the finer surface
 * \param[in] owner cell of each of its points */
std::vector<Triangle>
dualTriangles(const std::vector<Triangle>& triangles, const std::vector<Index>& owner);

} // namespace symmetry
} // namespace pcl
