#include "symmetry/samples/coarse_surface.h"

#include "base/centroid.h"
#include "base/heartbeat.h"
#include "base/renumbering.h"
#include "base/sort_unique.h"
#include "base/vector_math.h"
#include "cloud/local_delaunay.h"
#include "symmetry/samples/hole_cells.h"
#include "symmetry/samples/sample_settings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr CellSettings settings{};

/** Adjacent cells, joined by the length of the shortest way from sample to sample that crosses their border once. */
SurfaceGraph
joinCells(const SurfaceGraph& graph, const FarthestPointSamples& cells)
{
  std::vector<GraphEdge> edges;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (const auto [w, length] : graph.edges(v)) {
      if (cells.owner[v] < cells.owner[w]) {
        edges.push_back({cells.owner[v], cells.owner[w], cells.distance[v] + length + cells.distance[w]});
      }
    }
  }
  return buildGraph(cells.vertices.size(), edges);
}

/** Cotangent of the angle between two edges; bounded, so that slivers do not take over. */
float
cotangent(const Vector3& a, const Vector3& b)
{
  const float sine = norm(cross(a, b));
  const float cosine = dot(a, b);
  return sine * settings.cotangent_bound <= std::abs(cosine) ? std::copysign(settings.cotangent_bound, cosine)
                                                             : cosine / sine;
}

/** Finite volumes: for a function that is linear between two samples, the cotangent flow over all edges that cross the
 * border of their cells is exact however ragged the border. */
std::vector<float>
cellConductances(const PreparedSurface& surface, const CoarseSurface& coarse)
{
  std::vector<float> conductances(coarse.graph.neighbours.size(), 0.0F);
  const auto add_flow = [&](Index u, Index v, float weight) {
    const Index i = coarse.cells.owner[u];
    const Index j = coarse.cells.owner[v];
    if (i != j) {
      const Vector3 direction = normalized(coarse.points[j] - coarse.points[i]);
      const float flow = weight * dot(surface.points[v] - surface.points[u], direction);
      const std::size_t forth = edgeNumber(coarse.graph, i, j);
      const std::size_t back = edgeNumber(coarse.graph, j, i);
      conductances[forth] += flow / coarse.graph.lengths[forth];
      conductances[back] += flow / coarse.graph.lengths[back];
    }
  };
  for (const Triangle& t : surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index u = t[(k + 1) % 3];
      const Index v = t[(k + 2) % 3];
      const Vector3& apex = surface.points[t[k]];
      add_flow(u, v, 0.5F * cotangent(surface.points[u] - apex, surface.points[v] - apex));
    }
  }
  for (float& c : conductances) {
    c = std::max(c, settings.minimum_conductance);
  }
  return conductances;
}

/** Area of each cell as a share of the whole; a third of every triangle goes to each of its corners' cells. Without
 * triangles, or with all of them flat, every point counts the same. */
std::vector<float>
cellAreas(const PreparedSurface& surface, const FarthestPointSamples& cells)
{
  std::vector<double> areas(cells.vertices.size(), 0.0);
  for (const Triangle& t : surface.triangles) {
    const Vector3& p = surface.points[t[0]];
    const double area = norm(cross(surface.points[t[1]] - p, surface.points[t[2]] - p));
    for (const Index v : t) {
      areas[cells.owner[v]] += area;
    }
  }
  double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (!(total > 0.0)) {
    for (const Index owner : cells.owner) {
      areas[owner] += 1.0;
    }
    total = static_cast<double>(cells.owner.size());
  }
  std::vector<float> shares(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    shares[i] = static_cast<float>(areas[i] / total);
  }
  return shares;
}

std::vector<Vector3>
cellNormals(const PreparedSurface& surface, const FarthestPointSamples& cells)
{
  std::vector<Vector3> normals(cells.vertices.size(), Vector3{0.0F, 0.0F, 0.0F});
  for (std::size_t v = 0; v < surface.size(); ++v) {
    Vector3& sum = normals[cells.owner[v]];
    sum = sum + surface.normals[v];
  }
  for (Vector3& n : normals) {
    n = normalized(n);
  }
  return normals;
}

/** A cloud has no faces to measure cells by, but the samples are spread evenly whatever the density of the points. */
void
triangulateCells(CoarseSurface& coarse)
{
  FanLaplacian laplacian = localDelaunayLaplacian(coarse.points, coarse.normals, coarse.graph);
  coarse.triangles = std::move(laplacian.triangles);
  coarse.areas = std::move(laplacian.areas);
  coarse.conductances = std::move(laplacian.conductances);
  for (float& c : coarse.conductances) {
    c = std::max(c, settings.minimum_conductance);
  }
}

} // namespace

float
sampleSpacing(const CoarseSurface& coarse)
{
  const std::vector<float>& lengths = coarse.graph.lengths;
  return std::accumulate(lengths.begin(), lengths.end(), 0.0F) /
         static_cast<float>(std::max<std::size_t>(lengths.size(), 1));
}

std::vector<Triangle>
dualTriangles(const std::vector<Triangle>& triangles, const std::vector<Index>& owner)
{
  std::vector<Triangle> dual;
  for (const Triangle& t : triangles) {
    const Triangle owners{owner[t[0]], owner[t[1]], owner[t[2]]};
    if (owners[0] != owners[1] && owners[1] != owners[2] && owners[2] != owners[0]) {
      dual.push_back(lowestFirst(owners));
    }
  }
  sortUnique(dual);
  // A surface has two per cell. Faces that join anything with anything have thousands, and no sense of orientation that
  // every other one of them would not have as well.
  constexpr std::size_t points_per_cell = 8;
  const std::size_t most =
      points_per_cell * static_cast<std::size_t>(owner.empty() ? 0 : *std::max_element(owner.begin(), owner.end()) + 1);
  if (dual.size() > most) {
    const std::size_t step = (dual.size() + most - 1) / most;
    for (std::size_t i = 0; i * step < dual.size(); ++i) {
      dual[i] = dual[i * step];
    }
    dual.resize((dual.size() + step - 1) / step);
  }
  return dual;
}

CoarseSurface
coarsenSurface(const PreparedSurface& surface, std::size_t samples)
{
  CoarseSurface coarse;
  coarse.cells = farthestPointSampling(surface.graph, farthestFromCentroid(surface.points), samples);
  for (const Index v : coarse.cells.vertices) {
    coarse.points.push_back(surface.points[v]);
  }
  heartbeat();
  coarse.normals = cellNormals(surface, coarse.cells);
  coarse.graph = joinCells(surface.graph, coarse.cells);
  if (surface.is_cloud) {
    triangulateCells(coarse);
  }
  else {
    coarse.triangles = dualTriangles(surface.triangles, coarse.cells.owner);
    heartbeat();
    coarse.areas = cellAreas(surface, coarse.cells);
    coarse.conductances = cellConductances(surface, coarse);
  }
  heartbeat();
  coarse.at_hole = cellsAtHoles(surface, coarse.cells, sampleSpacing(coarse));
  return coarse;
}

} // namespace symmetry
} // namespace pcl
