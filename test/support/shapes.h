/** \file
 * \brief Surfaces of known shape for the tests.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Unit square in the plane z = 0 of columns x rows vertices, vertex (i, j) is j * columns + i. */
inline Surface
gridMesh(int columns, int rows)
{
  Surface grid;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      grid.points.push_back({static_cast<float>(i), static_cast<float>(j), 0.0F});
    }
  }
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const Index a = j * columns + i;
      grid.triangles.push_back({a, a + 1, a + columns + 1});
      grid.triangles.push_back({a, a + columns + 1, a + columns});
    }
  }
  return grid;
}

/** \brief The mesh with every triangle split into four; the new points follow the old ones. */
inline Surface
finer(const Surface& mesh)
{
  Surface split;
  split.points = mesh.points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, added] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(split.points.size()));
    if (added) {
      Vector3 m{};
      for (std::size_t k = 0; k < 3; ++k) {
        m[k] = 0.5F * (mesh.points[a][k] + mesh.points[b][k]);
      }
      split.points.push_back(m);
    }
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    split.triangles.insert(split.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return split;
}

/** \brief Unit sphere: an octahedron whose triangles are split into four, \a levels times. */
inline Surface
sphereMesh(int levels)
{
  Surface sphere;
  sphere.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  sphere.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    const std::size_t old = sphere.size();
    sphere = finer(sphere);
    for (std::size_t v = old; v < sphere.size(); ++v) {
      Vector3& p = sphere.points[v];
      const float radius = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for (float& x : p) {
        x /= radius;
      }
    }
  }
  return sphere;
}

/** \brief Torus around the z axis; \a around vertices along the large circle of radius \a large, \a across along the
 * small one. */
inline Surface
torusMesh(int around, int across, float large, float small)
{
  constexpr float turn = 6.28318531F;
  Surface torus;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      // Half a step off, so that no vertex lies on the planes x = 0 and y = 0.
      const float u = turn * (static_cast<float>(i) + 0.5F) / static_cast<float>(around);
      const float v = turn * static_cast<float>(j) / static_cast<float>(across);
      const float r = large + small * std::cos(v);
      torus.points.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
      const Index a = i * across + j;
      const Index b = ((i + 1) % around) * across + j;
      const Index c = ((i + 1) % around) * across + (j + 1) % across;
      const Index d = i * across + (j + 1) % across;
      torus.triangles.push_back({a, b, c});
      torus.triangles.push_back({a, c, d});
    }
  }
  return torus;
}

/** \brief The surface with every point scaled along the axes. */
inline Surface
scaled(Surface surface, const Vector3& factors)
{
  for (Vector3& p : surface.points) {
    p = {p[0] * factors[0], p[1] * factors[1], p[2] * factors[2]};
  }
  return surface;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
