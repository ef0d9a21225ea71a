/** \file
 * \brief Prepared surfaces for tests of the steps after the preparation.
 */
#pragma once

#include "support/shapes.h"
#include "symmetry/surface/surface_preparation.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief A connected mesh as it is. */
inline PreparedSurface
prepared(const Surface& mesh)
{
  PreparedSurface surface;
  surface.points = mesh.points;
  surface.triangles = mesh.triangles;
  surface.graph = buildMeshGraph(mesh.points, mesh.triangles);
  surface.original.resize(mesh.size());
  std::iota(surface.original.begin(), surface.original.end(), 0);
  surface.representatives = surface.original;
  return surface;
}

/** \brief A mesh as the estimation prepares it. */
inline PreparedSurface
preparedMesh(const Surface& mesh)
{
  return prepareSurface(mesh, SymmetryParameters{}, NeighbourSearch{});
}

/** \brief The mesh with vertex v renamed to new_number[v]. */
inline Surface
renumbered(const Surface& mesh, const std::vector<Index>& new_number)
{
  Surface renamed = mesh;
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    renamed.points[new_number[v]] = mesh.points[v];
  }
  for (Triangle& t : renamed.triangles) {
    t = {new_number[t[0]], new_number[t[1]], new_number[t[2]]};
  }
  return renamed;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
