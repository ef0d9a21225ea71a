/** \file
 * \brief Graphs for the tests of the geodesic module.
 */
#pragma once

#include "geodesic/surface_graph.h"
#include "support/shapes.h"

#include <random>

namespace pcl {
namespace symmetry {
namespace test {

inline SurfaceGraph
meshGraph(const Surface& mesh)
{
  return buildMeshGraph(mesh.points, mesh.triangles);
}

/** \brief Connected random graph: a random tree and as many edges again; lengths by a function of the generator. */
template <typename Length>
SurfaceGraph
randomGraph(int vertices, unsigned seed, Length length)
{
  std::mt19937 random(seed);
  std::vector<GraphEdge> edges;
  for (Index v = 1; v < vertices; ++v) {
    const auto parent = static_cast<Index>(random() % static_cast<unsigned>(v));
    edges.push_back({v, parent, length(random)});
    const auto other = static_cast<Index>(random() % static_cast<unsigned>(vertices));
    edges.push_back({v, other, length(random)});
  }
  return buildGraph(static_cast<std::size_t>(vertices), edges);
}

/** \brief Lengths evenly spread over (0, 1]. */
inline float
evenLength(std::mt19937& random)
{
  return static_cast<float>(random() % 1000U + 1U) / 1000.0F;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
