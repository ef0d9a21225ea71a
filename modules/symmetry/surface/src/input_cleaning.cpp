#include "symmetry/surface/input_cleaning.h"

#include "base/bounding_box.h"
#include "base/coincident_points.h"
#include "base/renumbering.h"
#include "base/statistics.h"
#include "base/union_find.h"
#include "base/vector_math.h"
#include "cloud/cloud_normals.h"
#include "cloud/merged_sheets.h"
#include "cloud/resampled_cloud.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl {
namespace symmetry {
namespace {

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

/** Distances of all points from the middle of them. Medians, since a mean would follow what is far. */
std::vector<double>
distancesFromMiddle(const std::vector<Vector3>& points)
{
  std::array<double, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> coordinates;
    coordinates.reserve(points.size());
    for (const Vector3& p : points) {
      coordinates.push_back(double{p[k]});
    }
    middle[k] = median(std::move(coordinates));
  }
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Vector3& p : points) {
    distances.push_back(std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]));
  }
  return distances;
}

/** Drops points of a cloud that are so far from the middle of all that no surface reaches there: at unit scale they
 * would leave few bits for all others. */
void
dropStrayPoints(PreparedSurface& surface)
{
  constexpr double far = 1e4; // times as far from the middle as half of the points
  if (surface.size() == 0) {
    return;
  }
  const std::vector<double> distances = distancesFromMiddle(surface.points);
  const double typical = median(distances);
  std::vector<char> keep(surface.size());
  std::transform(distances.begin(), distances.end(), keep.begin(),
                 [typical](double d) { return !(typical > 0.0) || d <= far * typical; });
  const auto stray = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  if (stray > 0) {
    surface.summary.outliers += stray;
    keepPoints(surface, keep);
  }
}

/** Box of a mesh's largest component, since the others take no part; points that no face uses do not either. */
BoundingBox
boxOfLargestComponent(const PreparedSurface& surface)
{
  UnionFind components(surface.size());
  for (const Triangle& t : surface.triangles) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
  }
  const Index largest = components.largest();
  BoundingBox box;
  for (const Triangle& t : surface.triangles) {
    if (components.find(t[0]) == largest) {
      std::for_each(t.begin(), t.end(), [&](Index v) { box.extend(surface.points[v]); });
    }
  }
  return box;
}

/** Moves the middle of the surface's box to the origin and scales its longest side to 1, in double: coordinates may be
 * huge. What does not take part is outside the box: were it far away, it would leave few bits for all others. */
void
normalizeScale(PreparedSurface& surface)
{
  const BoundingBox box = surface.triangles.empty() ? boundingBox(surface.points) : boxOfLargestComponent(surface);
  const double extent = box.longestSide();
  const double scale = extent > 0.0 ? 1.0 / extent : 1.0;
  const std::array<double, 3> centre = box.centre();
  for (Vector3& p : surface.points) {
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = static_cast<float>((p[k] - centre[k]) * scale);
    }
  }
  surface.scale = static_cast<float>(scale);
}

/** Leaves out the parts of a cloud that are farther from the largest one than this is long, another body or single
 * points, and scales what is left anew: all tolerances are relative to it.
 * \param[in] input where the points come from, with the digits that they have lost at the scale of all
 * \param[in,out] surface a cloud */
void
dropFarParts(const std::vector<Vector3>& input,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             PreparedSurface& surface)
{
  constexpr double suspicious = 8.0; // box over median distance from the middle; of one body two to five
  constexpr std::size_t fewest = 20; // fewer points are no part of their own
  if (surface.size() == 0 ||
      suspicious * median(distancesFromMiddle(surface.points)) >= boundingBox(surface.points).longestSide()) {
    return;
  }
  const NeighbourLists lists = search(surface.points, parameters.k_search);
  const auto are_near = [&lists](Index of, Index v) {
    const IndexRange around = lists.of(of);
    return std::find(around.begin(), around.end(), v) != around.end();
  };
  UnionFind parts(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (const Index u : lists.of(v)) {
      if (are_near(u, static_cast<Index>(v))) { // a stray point has neighbours, but is nobody's
        parts.join(static_cast<Index>(v), u);
      }
    }
  }
  const Index largest = parts.largest();
  BoundingBox box;
  std::vector<std::size_t> sizes(surface.size(), 0);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Index part = parts.find(static_cast<Index>(v));
    ++sizes[part];
    if (part == largest) {
      box.extend(surface.points[v]);
    }
  }
  std::vector<char> keep(surface.size());
  std::transform(surface.points.begin(), surface.points.end(), keep.begin(),
                 [&box](const Vector3& p) { return box.distanceTo(p) <= box.longestSide(); });
  for (const Index v : surface.representatives) {
    if (v != no_index && keep[v] == 0) {
      ++(sizes[parts.find(v)] < fewest ? surface.summary.outliers : surface.summary.other_components);
    }
  }
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const bool is_part = parts.find(static_cast<Index>(v)) == static_cast<Index>(v) && sizes[v] >= fewest;
    surface.summary.components += is_part && keep[v] == 0 ? 1U : 0U;
  }
  if (std::find(keep.begin(), keep.end(), 0) != keep.end()) {
    keepPoints(surface, keep);
    std::transform(surface.original.begin(), surface.original.end(), surface.points.begin(),
                   [&input](Index v) { return input[v]; });
    normalizeScale(surface);
  }
}

/** Statistical outlier removal (R. Rusu et al., 2008): drops the points whose mean distance to their neighbours exceeds
 * the mean of the cloud by more than so many standard deviations. */
void
dropOutliers(PreparedSurface& surface, const SymmetryParameters& parameters, const NeighbourSearch& search)
{
  const NeighbourLists lists = search(surface.points, parameters.k_search);
  std::vector<double> mean_distance(surface.size(), 0.0);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (const Index u : lists.of(v)) {
      mean_distance[v] += distance(surface.points[v], surface.points[u]);
    }
    mean_distance[v] /= static_cast<double>(std::max<std::size_t>(lists.of(v).size(), 1));
    sum += mean_distance[v];
    sum_of_squares += mean_distance[v] * mean_distance[v];
  }
  const auto count = static_cast<double>(std::max<std::size_t>(surface.size(), 1));
  const double deviation = std::sqrt(std::max(0.0, sum_of_squares / count - (sum / count) * (sum / count)));
  const double largest = sum / count + double{parameters.outlier_deviations} * deviation;
  std::vector<char> keep(surface.size());
  std::transform(mean_distance.begin(), mean_distance.end(), keep.begin(),
                 [largest](double d) { return d <= largest; });
  const std::size_t before = countLeftOut(surface);
  keepPoints(surface, keep);
  surface.summary.outliers += countLeftOut(surface) - before;
}

/** Lets the first of several points at one place stand for all: in a cloud they would take up each other's neighbours,
 * and a mesh falls apart at the seams of its texture, where exporters repeat the vertices. */
void
mergeRepeatedPoints(PreparedSurface& surface)
{
  const std::vector<Index> first = firstCoincident(surface.points);
  std::vector<char> keep(surface.size());
  for (std::size_t v = 0; v < keep.size(); ++v) {
    keep[v] = static_cast<char>(first[v] == static_cast<Index>(v));
  }
  if (std::find(keep.begin(), keep.end(), 0) == keep.end()) {
    return;
  }
  renumber(surface.representatives, first);
  renumberTriangles(surface.triangles, first);
  keepPoints(surface, keep);
}

/** Goes over to a cloud without outliers and noise, of a size that is solved in a moment, and finds the neighbours of
 * its points. */
void
reduceCloud(UsablePoints& usable,
            const SymmetryParameters& parameters,
            const NeighbourSearch& search,
            NoiseInterpretation interpretation)
{
  constexpr std::size_t most = 60000;
  PreparedSurface& surface = usable.surface;
  usable.neighbours = search(surface.points, parameters.k_search);
  ResampledCloud working = resampleCloud(surface.points, usable.neighbours, most, parameters.threads, interpretation);
  if (working.points.size() == surface.size() && working.smoothing_radius == 0.0F && working.normals.empty()) {
    return;
  }
  surface.summary.smoothing_radius = working.smoothing_radius / surface.scale;
  const std::size_t left_out_before = countLeftOut(surface);
  renumber(surface.representatives, working.representatives);
  surface.summary.outliers += countLeftOut(surface) - left_out_before;
  std::vector<Index> original;
  std::vector<Vector3> normals;
  for (const Index v : working.original) {
    original.push_back(surface.original[v]);
    if (!surface.normals.empty()) {
      normals.push_back(surface.normals[v]);
    }
  }
  surface.original = std::move(original);
  surface.normals = std::move(normals);
  surface.points = std::move(working.points);
  if (working.normals.empty()) {
    usable.neighbours = search(surface.points, parameters.k_search);
    return;
  }
  // Where sheets were parted half of the neighbours are on the other one.
  usable.neighbours = neighboursOnOwnSheet(search(surface.points, 2 * parameters.k_search), working.normals,
                                           static_cast<std::size_t>(parameters.k_search));
  if (surface.normals.empty()) {
    surface.normals = std::move(working.normals);
    usable.is_oriented = std::move(working.is_oriented);
  }
}

/** Gives the points without a normal the one of the plane through their neighbours, to be turned as those around. */
void
completeNormals(UsablePoints& usable, unsigned threads)
{
  std::vector<Vector3>& normals = usable.surface.normals;
  std::vector<char> is_given(normals.size());
  std::transform(normals.begin(), normals.end(), is_given.begin(), isDirection);
  if (std::find(is_given.begin(), is_given.end(), 0) == is_given.end()) {
    return;
  }
  const std::vector<Vector3> planes = estimateNormals(usable.surface.points, usable.neighbours, threads);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    normals[v] = is_given[v] != 0 ? normals[v] : planes[v];
  }
  usable.is_oriented = std::move(is_given);
}

void
dropDegenerateTriangles(std::vector<Triangle>& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
                  triangles.end());
}

/** Keeps the first of several triangles with the same corners, whichever way they turn: doubled faces, as of two-sided
 * exports, would leave more than two triangles at every edge, which ends every line drawn over the surface. */
void
dropRepeatedTriangles(std::size_t n, std::vector<Triangle>& triangles)
{
  struct Corners {
    Index middle;
    Index highest;
    std::size_t triangle;
  };
  std::vector<Triangle> sorted = triangles;
  std::vector<std::size_t> offsets(n + 1, 0);
  for (Triangle& t : sorted) {
    std::sort(t.begin(), t.end());
    ++offsets[static_cast<std::size_t>(t[0]) + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());

  // Grouped by the lowest corner and in order within each group, what is equal stands side by side, the first in front.
  std::vector<Corners> corners(triangles.size());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    corners[next[sorted[i][0]]++] = {sorted[i][1], sorted[i][2], i};
  }
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(offsets[v]);
    const auto end = corners.begin() + static_cast<std::ptrdiff_t>(offsets[v + 1]);
    std::sort(begin, end, [](const Corners& x, const Corners& y) {
      return std::tie(x.middle, x.highest, x.triangle) < std::tie(y.middle, y.highest, y.triangle);
    });
    for (auto it = begin; it != end; ++it) {
      repeated[it->triangle] =
          static_cast<char>(it != begin && it->middle == (it - 1)->middle && it->highest == (it - 1)->highest);
    }
  }

  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (repeated[i] == 0) {
      triangles[kept++] = triangles[i];
    }
  }
  triangles.resize(kept);
}

/** Mean of the normals of the faces around each vertex, weighted by area. */
std::vector<Vector3>
vertexNormals(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Vector3> normals(points.size(), Vector3{0.0F, 0.0F, 0.0F});
  for (const Triangle& t : triangles) {
    const Vector3 doubled_area = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for (const Index v : t) {
      normals[v] = normals[v] + doubled_area;
    }
  }
  for (Vector3& n : normals) {
    n = normalized(n);
  }
  return normals;
}

/** Goes over from a mesh with normals to the cloud of its vertices. */
void
dropFaces(PreparedSurface& surface)
{
  surface.triangles.clear();
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
usablePoints(const Surface& surface,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             NoiseInterpretation interpretation,
             FaceUse faces)
{
  UsablePoints usable;
  PreparedSurface& prepared = usable.surface;
  prepared.points = surface.points;
  prepared.triangles = surface.triangles;
  prepared.is_cloud = !surface.hasFaces();
  const bool has_normals = prepared.is_cloud && parameters.normals == NormalSource::Given;
  if (has_normals) {
    std::transform(surface.normals.begin(), surface.normals.end(), std::back_inserter(prepared.normals), unitOrZero);
  }
  prepared.original.resize(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    prepared.original[v] = static_cast<Index>(v);
  }
  prepared.representatives = prepared.original;
  prepared.summary.points = surface.size();
  prepared.summary.faces = surface.triangles.size();

  dropNonFinitePoints(prepared);
  if (prepared.is_cloud) {
    dropStrayPoints(prepared);
  }
  else {
    mergeRepeatedPoints(prepared);
    dropDegenerateTriangles(prepared.triangles);
    dropRepeatedTriangles(prepared.size(), prepared.triangles);
  }
  normalizeScale(prepared);
  if (!prepared.is_cloud) {
    prepared.normals = vertexNormals(prepared.points, prepared.triangles);
    if (faces == FaceUse::Connection) {
      return usable;
    }
    dropFaces(prepared);
  }
  mergeRepeatedPoints(prepared);
  dropFarParts(surface.points, parameters, search, prepared);
  if (parameters.outlier_deviations > 0.0F) {
    dropOutliers(prepared, parameters, search);
  }
  reduceCloud(usable, parameters, search, interpretation);
  if (has_normals) {
    completeNormals(usable, parameters.threads);
  }
  return usable;
}

} // namespace symmetry
} // namespace pcl
