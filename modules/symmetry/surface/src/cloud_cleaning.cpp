#include "symmetry/surface/cloud_cleaning.h"

#include "base/bounding_box.h"
#include "base/renumbering.h"
#include "base/sort_unique.h"
#include "base/statistics.h"
#include "base/union_find.h"
#include "base/vector_math.h"
#include "cloud/cloud_normals.h"
#include "cloud/merged_sheets.h"
#include "symmetry/surface/scale_normalization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

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

/** Whether points at unit scale are in so few places that what they show is next to nothing beside the way between them:
 * a surface has a hundred points in a cube of a thousandth of its size only where it has a hundred million of them. */
bool
isInFewPlaces(const std::vector<Vector3>& points)
{
  constexpr float cubes = 1024.0F; // along the longest side: ten bits, and one for the sign
  constexpr std::size_t crowded = 100;
  constexpr std::int64_t offset = 1024;
  std::vector<std::int64_t> places(points.size());
  std::transform(points.begin(), points.end(), places.begin(), [](const Vector3& p) {
    std::int64_t place = 0;
    for (const float x : p) {
      place = 2 * offset * place + static_cast<std::int64_t>(std::floor(cubes * x)) + offset;
    }
    return place;
  });
  sortUnique(places);
  return points.size() > crowded * places.size();
}

} // namespace

void
dropFarOutliers(PreparedSurface& surface)
{
  constexpr double maximum_distance = 1e4; // times as far from the middle as half of the points
  if (surface.size() == 0) {
    return;
  }
  const std::vector<double> distances = distancesFromMiddle(surface.points);
  const double typical = median(distances);
  std::vector<char> keep(surface.size());
  std::transform(distances.begin(), distances.end(), keep.begin(),
                 [typical](double d) { return !(typical > 0.0) || d <= maximum_distance * typical; });
  const auto outliers = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  if (outliers > 0) {
    surface.summary.outliers += outliers;
    keepPoints(surface, keep);
  }
}

void
dropFarParts(const std::vector<Vector3>& input,
             const SymmetryParameters& parameters,
             const NeighbourSearch& search,
             PreparedSurface& surface)
{
  constexpr double maximum_ratio = 8.0;    // box over median distance from the middle; of one body two to five
  constexpr std::size_t minimum_part = 20; // points; fewer are no part of their own
  if (surface.size() == 0 ||
      (maximum_ratio * median(distancesFromMiddle(surface.points)) >= boundingBox(surface.points).longestSide() &&
       !isInFewPlaces(surface.points))) {
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
      if (are_near(u, static_cast<Index>(v))) { // an outlier has neighbours, but is nobody's
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
      ++(sizes[parts.find(v)] < minimum_part ? surface.summary.outliers : surface.summary.other_components);
    }
  }
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const bool is_part = parts.find(static_cast<Index>(v)) == static_cast<Index>(v) && sizes[v] >= minimum_part;
    surface.summary.components += is_part && keep[v] == 0 ? 1U : 0U;
  }
  if (std::find(keep.begin(), keep.end(), 0) != keep.end()) {
    keepPoints(surface, keep);
    std::transform(surface.original.begin(), surface.original.end(), surface.points.begin(),
                   [&input](Index v) { return input[v]; });
    normalizeScale(surface);
  }
}

void
dropStatisticalOutliers(PreparedSurface& surface, const SymmetryParameters& parameters, const NeighbourSearch& search)
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

void
resample(UsablePoints& usable,
         const SymmetryParameters& parameters,
         const NeighbourSearch& search,
         NoiseInterpretation interpretation)
{
  constexpr std::size_t maximum_points = 60000;
  PreparedSurface& surface = usable.surface;
  usable.neighbours = search(surface.points, parameters.k_search);
  ResampledCloud resampled = resampleCloud(surface.points, usable.neighbours, maximum_points, interpretation);
  if (resampled.points.size() == surface.size() && resampled.smoothing_radius == 0.0F && resampled.normals.empty()) {
    return;
  }
  surface.summary.smoothing_radius = resampled.smoothing_radius / surface.scale;
  const std::size_t left_out_before = countLeftOut(surface);
  renumber(surface.representatives, resampled.representatives);
  surface.summary.outliers += countLeftOut(surface) - left_out_before;
  std::vector<Index> original;
  std::vector<Vector3> normals;
  for (const Index v : resampled.original) {
    original.push_back(surface.original[v]);
    if (!surface.normals.empty()) {
      normals.push_back(surface.normals[v]);
    }
  }
  surface.original = std::move(original);
  surface.normals = std::move(normals);
  surface.points = std::move(resampled.points);
  if (resampled.normals.empty()) {
    usable.neighbours = search(surface.points, parameters.k_search);
    return;
  }
  // Where sheets were parted half of the neighbours are on the other one.
  usable.neighbours = neighboursOnOwnSheet(search(surface.points, 2 * parameters.k_search), resampled.normals,
                                           static_cast<std::size_t>(parameters.k_search));
  if (surface.normals.empty()) {
    surface.normals = std::move(resampled.normals);
    usable.is_oriented = std::move(resampled.is_oriented);
  }
}

void
completeNormals(UsablePoints& usable)
{
  std::vector<Vector3>& normals = usable.surface.normals;
  std::vector<char> is_given(normals.size());
  std::transform(normals.begin(), normals.end(), is_given.begin(), isDirection);
  if (std::find(is_given.begin(), is_given.end(), 0) == is_given.end()) {
    return;
  }
  const std::vector<Vector3> planes = estimateNormals(usable.surface.points, usable.neighbours);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    normals[v] = is_given[v] != 0 ? normals[v] : planes[v];
  }
  usable.is_oriented = std::move(is_given);
}

} // namespace symmetry
} // namespace pcl
