#include "base/renumbering.h"
#include "base/thread_scope.h"
#include "base/vector_math.h"
#include "neighbour_search.h"
#include "refuse_argument.h"
#include "symmetry/pipeline.h"
#include "symmetry/sides/mirror_plane.h"
#include "symmetry/step_timer.h"

#include <pcl/symmetry/impl/surface_estimation.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

void
checkTriangles(const Surface& surface)
{
  const auto count = static_cast<Index>(surface.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    for (const Index v : surface.triangles[i]) {
      if (v < 0 || v >= count) {
        refuseArgument("triangle ", i, " refers to point ", v, ", there are ", count, " points");
      }
    }
  }
}

void
checkNormals(const Surface& surface)
{
  if (!surface.normals.empty() && surface.normals.size() != surface.size()) {
    refuseArgument("there are ", surface.normals.size(), " normals for ", surface.size(), " points");
  }
}

/** Point types with normals hold zeros until somebody estimates them. */
void
checkGivenNormals(const Surface& surface, const SymmetryParameters& parameters)
{
  if (parameters.normals != NormalSource::Given || surface.hasFaces()) {
    return;
  }
  if (surface.normals.empty()) {
    refuseArgument("given normals are asked for, but the cloud has none");
  }
  if (std::none_of(surface.normals.begin(), surface.normals.end(),
                   [](const Vector3& normal) { return isDirection(unitOrZero(normal)); })) {
    refuseArgument("given normals are asked for, but those of the cloud are all zero or not finite");
  }
}

/** The selected part of a surface: points in the order of the selection, triangles with all corners among them. */
Surface
selectPoints(const Surface& surface, const std::vector<Index>& selection)
{
  std::vector<Index> new_number(surface.size(), no_index);
  Surface selected;
  for (const Index v : selection) {
    if (v < 0 || static_cast<std::size_t>(v) >= surface.size()) {
      refuseArgument("index ", v, " is out of range, there are ", surface.size(), " points");
    }
    if (new_number[v] != no_index) {
      refuseArgument("index ", v, " is given twice");
    }
    new_number[v] = static_cast<Index>(selected.points.size());
    selected.points.push_back(surface.points[v]);
    if (!surface.normals.empty()) {
      selected.normals.push_back(surface.normals[v]);
    }
  }
  selected.triangles = surface.triangles;
  renumberTriangles(selected.triangles, new_number);
  return selected;
}

/** Makes a result about selected points one about all points. */
void
expandSelection(SymmetryResult& result, const Surface& surface, const std::vector<Index>& selection)
{
  const std::size_t size = surface.size();
  renumber(result.partners, selection);
  scatter(result.partners, selection, size, no_index);
  scatter(result.confidences, selection, size, 0.0F);
  scatter(result.support, selection, size, 0.0F);
  scatter(result.sides, selection, size, Side::None);
  scatter(result.regions, selection, size, Region::None);
  renumber(result.extremities, selection);
  for (UnsupportedPart& part : result.unsupported) {
    part.extreme = selection[part.extreme];
  }
  for (SymmetricMatch& match : result.matches) {
    match.source = selection[match.source];
    match.target = selection[match.target];
    match.midpoint = match.midpoint == no_index ? no_index : selection[match.midpoint];
  }
  for (Polyline& line : result.axis) {
    renumber(line.points, selection);
    for (AxisPoint& point : line.curve) {
      point.nearest = selection[point.nearest];
    }
  }
  for (std::vector<AlternativeMap>* maps : {&result.alternatives, &result.rotations}) {
    for (AlternativeMap& map : *maps) {
      renumber(map.partners, selection);
      scatter(map.partners, selection, size, no_index);
    }
  }
  result.input.points = size;
  result.input.faces = surface.triangles.size();
  result.input.outside_indices = size - selection.size();
}

/** The caller's search, or PCL's kd-tree. */
NeighbourSearch
neighbourSearch(const detail::NeighbourSearchFunction& search)
{
  if (!search) {
    return searchByKdTree;
  }
  return [&search](const std::vector<Vector3>& points, int k) {
    const int possible = static_cast<int>(std::min(static_cast<std::size_t>(k), points.size()));
    return NeighbourLists{static_cast<std::size_t>(possible), search(points, possible)};
  };
}

} // namespace

SymmetryResult
detail::estimateSelected(const Surface& surface,
                         const std::vector<Index>* selection,
                         const SymmetryParameters& parameters,
                         const NeighbourSearchFunction& search,
                         const ProgressCallback& progress)
{
  checkParameters(parameters);
  checkTriangles(surface);
  checkNormals(surface);
  const ThreadScope threads(parameters.threads);
  StepTimer timer;
  if (progress) {
    timer = StepTimer(progress);
  }
  const NeighbourSearch neighbours = neighbourSearch(search);
  if (selection == nullptr) {
    checkGivenNormals(surface, parameters);
    SymmetryResult result = runPipeline(surface, parameters, neighbours, timer);
    result.plane = movedPlane(result.plane, 1.0, surface.offset);
    return result;
  }
  const Surface selected = selectPoints(surface, *selection);
  checkGivenNormals(selected, parameters);
  SymmetryResult result = runPipeline(selected, parameters, neighbours, timer);
  expandSelection(result, surface, *selection);
  result.plane = movedPlane(result.plane, 1.0, surface.offset);
  return result;
}

SymmetryResult
estimateIntrinsicSymmetry(const Surface& surface,
                          const SymmetryParameters& parameters,
                          const ProgressCallback& progress)
{
  return detail::estimateSelected(surface, nullptr, parameters, {}, progress);
}

std::vector<Triangle>
detail::triangulatePolygons(const PolygonMesh& mesh)
{
  const std::size_t points = std::size_t{mesh.cloud.width} * mesh.cloud.height;
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.polygons.size());
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const auto& corners = mesh.polygons[i].vertices;
    for (const auto corner : corners) {
      if (static_cast<std::size_t>(corner) >= points) {
        refuseArgument("polygon ", i, " refers to point ", corner, ", there are ", points, " points");
      }
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      triangles.push_back(
          {static_cast<Index>(corners[0]), static_cast<Index>(corners[k - 1]), static_cast<Index>(corners[k])});
    }
  }
  return triangles;
}

} // namespace symmetry
} // namespace pcl
