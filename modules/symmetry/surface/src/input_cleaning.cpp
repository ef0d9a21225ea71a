#include "symmetry/surface/input_cleaning.h"

#include "base/heartbeat.h"
#include "base/vector_math.h"
#include "symmetry/surface/cloud_cleaning.h"
#include "symmetry/surface/junction_closing.h"
#include "symmetry/surface/mesh_cleaning.h"
#include "symmetry/surface/mesh_subdivision.h"
#include "symmetry/surface/scale_normalization.h"
#include "symmetry/surface/seam_welding.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** All points of the input, as they are. */
PreparedSurface
takeIn(const Surface& surface, bool with_normals)
{
  PreparedSurface prepared;
  prepared.points = surface.points;
  prepared.triangles = surface.triangles;
  prepared.is_cloud = !surface.hasFaces();
  if (with_normals) {
    std::transform(surface.normals.begin(), surface.normals.end(), std::back_inserter(prepared.normals), unitOrZero);
  }
  prepared.original.resize(surface.size());
  std::iota(prepared.original.begin(), prepared.original.end(), 0);
  prepared.representatives = prepared.original;
  prepared.summary.points = surface.size();
  prepared.summary.faces = surface.triangles.size();
  return prepared;
}

void
dropNonFinitePoints(PreparedSurface& surface)
{
  std::vector<char> keep(surface.size());
  std::transform(surface.points.begin(), surface.points.end(), keep.begin(), isFinite);
  surface.summary.non_finite = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  if (surface.summary.non_finite > 0) {
    keepPoints(surface, keep);
  }
}

/** Leaves what is one surface with every point and every triangle once. */
void
cleanMesh(PreparedSurface& surface)
{
  const auto drop_useless = [&surface] {
    dropDegenerateTriangles(surface.triangles);
    dropRepeatedTriangles(surface.size(), surface.triangles);
  };
  surface.summary.welded = mergeRepeatedPoints(surface);
  heartbeat();
  drop_useless();
  std::vector<OpenSide> sides = openSides(surface.size(), surface.triangles);
  if (const std::size_t welded = weldSeams(surface, sides); welded > 0) {
    surface.summary.welded += welded;
    drop_useless();
    sides = openSides(surface.size(), surface.triangles);
  }
  surface.summary.junctions = closeJunctions(surface, sides);
  dropUnusedPoints(surface);
}

/** Goes over from a mesh with normals to the cloud of its vertices. */
void
dropFaces(PreparedSurface& surface)
{
  surface.triangles.clear();
  surface.unsplit.clear();
  surface.is_cloud = true;
  surface.summary.read_as_cloud = true;
  std::vector<char> keep(surface.size());
  std::transform(surface.normals.begin(), surface.normals.end(), keep.begin(), isDirection);
  const std::size_t before = countLeftOut(surface);
  keepPoints(surface, keep);
  surface.summary.other_components += countLeftOut(surface) - before;
}

} // namespace

UsablePoints
distinctPoints(const Surface& cloud, const SymmetryParameters& parameters, const NeighbourSearch& search)
{
  UsablePoints usable;
  PreparedSurface& prepared = usable.surface;
  prepared = takeIn(cloud, parameters.normals == NormalSource::Given);
  dropNonFinitePoints(prepared);
  dropFarOutliers(prepared);
  normalizeScale(prepared);
  mergeRepeatedPoints(prepared);
  dropFarParts(cloud.points, parameters, search, prepared);
  constexpr int enough = 16; // for planes; more would link everything with everything
  usable.neighbours = search(prepared.points, std::min(parameters.k_search, enough));
  return usable;
}

UsablePoints
usablePoints(const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             NoiseInterpretation interpretation,
             FaceUse faces,
             std::size_t points)
{
  const bool has_normals = !surface.hasFaces() && parameters.normals == NormalSource::Given;
  UsablePoints usable;
  PreparedSurface& prepared = usable.surface;
  prepared = takeIn(surface, has_normals);

  dropNonFinitePoints(prepared);
  if (prepared.is_cloud) {
    dropFarOutliers(prepared);
  }
  else {
    cleanMesh(prepared);
  }
  heartbeat();
  normalizeScale(prepared);
  if (!prepared.is_cloud) {
    if (parameters.components == ComponentUse::Largest) {
      keepLargestComponent(prepared);
      renormalizeScale(prepared);
    }
    if (points > 0) {
      splitLongSides(prepared, points);
    }
    prepared.normals = vertexNormals(prepared.points, prepared.triangles);
    if (faces == FaceUse::Connection) {
      return usable;
    }
    dropFaces(prepared);
  }
  mergeRepeatedPoints(prepared);
  heartbeat();
  dropFarParts(surface.points, parameters, search, prepared);
  if (parameters.outlier_deviations > 0.0F) {
    dropStatisticalOutliers(prepared, parameters, search);
  }
  resample(usable, parameters, search, interpretation);
  if (has_normals) {
    completeNormals(usable);
  }
  return usable;
}

} // namespace symmetry
} // namespace pcl
