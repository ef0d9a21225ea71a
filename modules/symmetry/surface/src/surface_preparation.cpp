#include "symmetry/surface/surface_preparation.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "base/renumbering.h"
#include "base/statistics.h"
#include "base/vector_math.h"
#include "cloud/cloud_normals.h"
#include "symmetry/surface/mesh_subdivision.h"
#include "symmetry/surface/part_links.h"
#include "symmetry/surface/scale_normalization.h"

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
                                         contact, is_oriented);
  surface.graph = std::move(cloud.graph);
  surface.normals = std::move(cloud.normals);
  surface.triangles = std::move(cloud.triangles);
  surface.summary.bridges = cloud.bridges;
  surface.summary.distrusted_edges = cloud.distrusted_edges;
}

/** Restricts the surface to some of its points, and its graph. */
void
keepPointsAndEdges(PreparedSurface& surface, const std::vector<char>& keep)
{
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

/** How far points of each part are apart that are neighbours: of a mesh as far as its split sides are, of a cloud the
 * median edge. Faces that fill space have an area of many times that of the box around them: then no more than the width
 * of a limb, or all would touch. */
std::vector<float>
spacingsOfParts(const PreparedSurface& surface, const Components& parts)
{
  if (!surface.is_cloud) {
    constexpr double limb = 0.1; // of the longest side of all: one part, perhaps a small one, sets the scale so far
    const auto widest = static_cast<float>(limb * boundingBox(surface.points).longestSide());
    std::vector<float> even(parts.sizes.size(), std::min(widest, evenSpacing(surface, points_of_a_surface)));
    return even;
  }
  std::vector<std::vector<float>> lengths(parts.sizes.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (const auto [w, length] : surface.graph.edges(v)) {
      lengths[parts.component_of[v]].push_back(length);
    }
  }
  std::vector<float> spacings(lengths.size());
  std::transform(lengths.begin(), lengths.end(), spacings.begin(),
                 [](std::vector<float>& of_part) { return medianInPlace(of_part); });
  return spacings;
}

/** Links the parts of each object, where there are several and they are asked for. */
void
linkPartsOfObjects(PreparedSurface& surface, ComponentUse use, PartGaps gaps)
{
  const Components parts = connectedComponents(surface.graph);
  surface.summary.components += parts.sizes.size();
  if (parts.sizes.size() < 2 || use == ComponentUse::Largest) {
    return;
  }
  const LinkedParts linked = linkParts(surface.points, parts, spacingsOfParts(surface, parts), gaps);
  std::vector<GraphEdge> edges = linked.links;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (const auto [w, length] : surface.graph.edges(v)) {
      edges.push_back({static_cast<Index>(v), w, length});
    }
  }
  surface.graph = buildGraph(surface.size(), edges);
  surface.summary.part_links = linked.links.size();
  surface.part_of = parts.component_of;
}

/** Restricts the surface to the object with the largest area, of a cloud to the one with most points. */
void
keepLargestObject(PreparedSurface& surface)
{
  const Components objects = connectedComponents(surface.graph);
  if (objects.sizes.size() < 2) {
    return;
  }
  std::vector<double> sizes(objects.sizes.begin(), objects.sizes.end());
  if (!surface.is_cloud) {
    sizes.assign(sizes.size(), 0.0);
    for (const Triangle& t : surface.triangles) {
      const Vector3& a = surface.points[t[0]];
      sizes[objects.component_of[t[0]]] += norm(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
    }
  }
  const auto largest = static_cast<Index>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<char> keep(surface.size());
  std::transform(objects.component_of.begin(), objects.component_of.end(), keep.begin(),
                 [largest](Index object) { return object == largest; });
  keepPointsAndEdges(surface, keep);
}

/** Numbers the parts of what was kept from 0 on; the box that set the scale was that of one of them. */
void
numberParts(PreparedSurface& surface)
{
  std::vector<Index> parts = surface.part_of;
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  if (parts.size() < 2) {
    surface.part_of.clear();
    return;
  }
  for (Index& part : surface.part_of) {
    part = static_cast<Index>(std::lower_bound(parts.begin(), parts.end(), part) - parts.begin());
  }
  surface.summary.linked_parts = parts.size();
  renormalizeScale(surface);
}

/** Once there is a graph: links, leaves out and counts. */
void
finish(PreparedSurface& prepared, ComponentUse use, PartGaps gaps)
{
  linkPartsOfObjects(prepared, use, gaps);
  keepLargestObject(prepared);
  numberParts(prepared);
  prepared.summary.used = prepared.representatives.size() - countLeftOut(prepared);
  prepared.summary.working_points = prepared.size();
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
  finish(prepared, parameters.components, PartGaps::Narrow);
  return prepared;
}

PreparedSurface
prepareAsItStands(const Surface& cloud, const SymmetryParameters& parameters, const NeighbourSearch& search)
{
  UsablePoints usable = distinctPoints(cloud, parameters, search);
  PreparedSurface prepared = std::move(usable.surface);
  if (prepared.normals.empty()) {
    prepared.normals = estimateNormals(prepared.points, usable.neighbours);
  }
  prepared.graph = buildNeighbourGraph(prepared.points, usable.neighbours, 0.0F);
  finish(prepared, parameters.components, PartGaps::Any);
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
