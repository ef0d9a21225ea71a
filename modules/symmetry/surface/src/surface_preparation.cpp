#include "symmetry/surface/surface_preparation.h"

#include "base/heartbeat.h"
#include "base/renumbering.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Graph, normals and triangles of a cloud, which has none of them. */
void
reconstructCloud(PreparedSurface& surface,
                 const NeighbourLists& neighbours,
                 const std::vector<char>& is_oriented,
                 const SymmetryParameters& parameters,
                 const ContactTest& contact)
{
  CloudSurface cloud = buildCloudSurface(surface.points, neighbours, surface.normals, parameters.radius * surface.scale,
                                         contact, parameters.threads, is_oriented);
  surface.graph = std::move(cloud.graph);
  surface.normals = std::move(cloud.normals);
  surface.triangles = std::move(cloud.triangles);
  surface.summary.bridges = cloud.bridges;
  surface.summary.distrusted_edges = cloud.distrusted_edges;
}

/** Restricts the surface to the largest component of its graph. */
void
keepLargestComponent(PreparedSurface& surface)
{
  const Components components = connectedComponents(surface.graph);
  surface.summary.components += components.sizes.size();
  if (components.sizes.size() < 2) {
    return;
  }
  std::vector<char> keep(surface.size());
  std::transform(components.component_of.begin(), components.component_of.end(), keep.begin(),
                 [](Index component) { return component == 0; });
  const std::vector<Index> numbers = numbersOfKept(keep);
  SurfaceGraph graph;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (keep[v] != 0) {
      for (const auto [w, length] : surface.graph.edges(v)) {
        graph.neighbours.push_back(numbers[w]);
        graph.lengths.push_back(length);
      }
      graph.offsets.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
    }
  }
  surface.graph = std::move(graph);
  const std::size_t before = countLeftOut(surface);
  keepPoints(surface, keep);
  surface.summary.other_components += countLeftOut(surface) - before;
}

} // namespace

PreparedSurface
prepareSurface(UsablePoints usable, const SymmetryParameters& parameters, const ContactTest& contact)
{
  PreparedSurface prepared = std::move(usable.surface);
  if (prepared.is_cloud) {
    reconstructCloud(prepared, usable.neighbours, usable.is_oriented, parameters, contact);
  }
  else {
    prepared.graph = buildMeshGraph(prepared.points, prepared.triangles);
  }
  heartbeat();
  keepLargestComponent(prepared);
  prepared.summary.used = prepared.representatives.size() - countLeftOut(prepared);
  prepared.summary.working_points = prepared.size();
  return prepared;
}

PreparedSurface
prepareSurface(const Surface& surface,
               const SymmetryParameters& parameters,
               const NeighbourSearch& search,
               const ContactTest& contact)
{
  return prepareSurface(usablePoints(surface, parameters, search), parameters, contact);
}

} // namespace symmetry
} // namespace pcl
