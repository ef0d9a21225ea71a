/** \file
 * \brief Properties of triangle meshes, by plain counting.
 */
#pragma once

#include "model/polygonize.h"

#include <pcl/symmetry/surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief What a mesh is as a topological space. */
struct Topology {
  bool oriented_manifold = true;  ///< every directed edge once, the triangles around every vertex one fan
  std::size_t boundary_edges = 0; ///< edges with one triangle
  long euler = 0;                 ///< vertices - edges + triangles, of vertices in use
  std::size_t components = 0;
};

inline Index
findRoot(std::vector<Index>& parents, Index item)
{
  while (parents[static_cast<std::size_t>(item)] != item)
    item = parents[static_cast<std::size_t>(item)];
  return item;
}

/** \brief The triangles around each vertex are one fan when the edges opposite to it form one path or circle: as many
 * links as triangles, no branch, one piece. */
inline bool
starsAreFans(std::size_t vertices, const std::vector<Triangle>& triangles)
{
  std::vector<std::map<Index, Index>> links(vertices);
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!links[static_cast<std::size_t>(t[k])].emplace(t[(k + 1) % 3], t[(k + 2) % 3]).second)
        return false;
  for (const std::map<Index, Index>& link : links) {
    if (link.empty())
      continue;
    Index start = link.begin()->first;
    for (const auto& entry : link) // a path starts at the one vertex that nothing leads to
      if (std::none_of(link.begin(), link.end(), [&](const auto& other) { return other.second == entry.first; }))
        start = entry.first;
    std::size_t steps = 0;
    for (auto at = link.find(start); at != link.end() && steps < link.size(); at = link.find(at->second))
      ++steps;
    if (steps != link.size())
      return false;
  }
  return true;
}

inline Topology
topologyOf(std::size_t vertices, const std::vector<Triangle>& triangles)
{
  Topology topology;
  topology.oriented_manifold = starsAreFans(vertices, triangles);
  std::map<std::pair<Index, Index>, int> directed;
  std::vector<Index> parents(vertices);
  std::iota(parents.begin(), parents.end(), Index{0});
  std::vector<char> used(vertices, 0);
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      used[static_cast<std::size_t>(a)] = 1;
      topology.oriented_manifold = ++directed[{a, b}] == 1 && topology.oriented_manifold;
      parents[static_cast<std::size_t>(findRoot(parents, a))] = findRoot(parents, b);
    }
  long edges = 0;
  for (const auto& entry : directed) {
    const bool twin = directed.count({entry.first.second, entry.first.first}) != 0;
    topology.boundary_edges += twin ? 0 : 1;
    edges += twin && entry.first.first > entry.first.second ? 0 : 1;
  }
  topology.euler = std::count(used.begin(), used.end(), 1) - edges + static_cast<long>(triangles.size());
  for (std::size_t v = 0; v < vertices; ++v)
    topology.components += used[v] != 0 && parents[v] == static_cast<Index>(v) ? 1 : 0;
  return topology;
}

inline TriangleMesh
toMesh(const Surface& surface)
{
  TriangleMesh mesh;
  for (const Vector3& p : surface.points)
    mesh.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  mesh.triangles = surface.triangles;
  return mesh;
}

/** \brief Volume inside a closed mesh; positive where triangles are counter-clockwise as seen from outside. */
inline double
volumeOf(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const Triangle& t : mesh.triangles)
    volume += mesh.points[static_cast<std::size_t>(t[0])].dot(
                  mesh.points[static_cast<std::size_t>(t[1])].cross(mesh.points[static_cast<std::size_t>(t[2])])) /
              6.0;
  return volume;
}

/** \brief Smallest angle of every triangle in degrees, ascending. */
inline std::vector<double>
smallestAngles(const TriangleMesh& mesh)
{
  std::vector<double> angles;
  for (const Triangle& t : mesh.triangles) {
    double smallest = 180.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& corner = mesh.points[static_cast<std::size_t>(t[k])];
      const Eigen::Vector3d a = mesh.points[static_cast<std::size_t>(t[(k + 1) % 3])] - corner;
      const Eigen::Vector3d b = mesh.points[static_cast<std::size_t>(t[(k + 2) % 3])] - corner;
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / 3.14159265358979);
    }
    angles.push_back(smallest);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
