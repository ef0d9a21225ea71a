#include "symmetry/mirror_method.h"

#include "base/bounding_box.h"
#include "base/centroid.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "geodesic/farthest_point_sampling.h"
#include "symmetry/confidence/support.h"
#include "symmetry/confidence/unsupported_parts.h"
#include "symmetry/interpretation_maps.h"
#include "symmetry/map_delivery.h"
#include "symmetry/mirror/mirror_map.h"
#include "symmetry/mirror/rooted_pieces.h"
#include "symmetry/mirror/surface_distance.h"
#include "symmetry/search/map_score.h"
#include "symmetry/sides/side_names.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

float
diagonalOf(const PreparedSurface& surface)
{
  return static_cast<float>(boundingBox(surface.points).diagonal());
}

/** Between the points of a sparse cloud the surface is known to a part of their distance only. */
float
toleranceFor(const PreparedSurface& surface, const PlaneSearchSettings& settings)
{
  constexpr float known_between_points = 0.25F; // of the distance of neighbours
  const float tolerance = settings.tolerance * diagonalOf(surface);
  return surface.is_cloud ? std::max(tolerance, known_between_points * median(surface.graph.lengths)) : tolerance;
}

MirrorMap
mapByPlane(const SampledSurface& sampled, const PlaneReflection& plane, const MirrorSettings& settings)
{
  const PreparedSurface& surface = sampled.surface;
  const float reach = settings.reach * diagonalOf(surface);
  // Of a mesh no farther than that: the sides of slivers are longer than points are apart.
  const float spacing = median(surface.graph.lengths);
  const float close =
      std::max(toleranceFor(surface, settings.planes), surface.is_cloud ? spacing : std::min(spacing, reach));
  return mapByMirror(surface, plane, close, std::max(close, reach));
}

/** The heights over the plane, positive on the side that the shape names so; what lies in it is on neither. */
std::vector<float>
sidesOfPlane(const SampledSurface& sampled, const PlaneReflection& plane)
{
  constexpr float rounding = 1e-5F; // surfaces are at unit scale
  std::vector<float> at_samples;
  float squares = 0.0F;
  for (const Vector3& p : sampled.coarse.points) {
    at_samples.push_back(plane.height(p));
    squares += at_samples.back() * at_samples.back();
  }
  const float scale = std::sqrt(static_cast<float>(at_samples.size()) / std::max(squares, 1e-12F));
  std::transform(at_samples.begin(), at_samples.end(), at_samples.begin(), [scale](float h) { return scale * h; });
  const float sign = chirality(sampled, at_samples) < 0.0 ? -1.0F : 1.0F;
  std::vector<float> sides;
  for (const Vector3& p : sampled.surface.points) {
    const float height = plane.height(p);
    sides.push_back(std::abs(height) < rounding ? 0.0F : sign * height);
  }
  return sides;
}

std::vector<MirrorFit>
planesThatFit(const PreparedSurface& surface, const AreaSamples& samples, const MirrorSettings& settings)
{
  PlaneSearchSettings search = settings.planes;
  const float diagonal = diagonalOf(surface);
  const float tolerance = toleranceFor(surface, settings.planes);
  if (tolerance > settings.planes.tolerance * diagonal) {
    search.tolerance = tolerance / diagonal;
    search.exact_residual = 0.0F; // between sparse points nothing is known exactly
  }
  return findMirrorPlanes(samples, surface, search);
}

/** The shares of the area that points of a cloud stand for: as the square of the distance to the sixth nearest, as many as
 * surround a point of an even lattice. Sampling evens a dense cloud out, but of one of few points all are samples: a lever
 * of a hundred corners would weigh as much as a seat of as many. No point counts more than a typical one: what strays has
 * the most room. */
std::vector<float>
areasAround(const std::vector<Vector3>& points)
{
  constexpr std::size_t neighbours = 6;
  constexpr std::size_t grain = 64;
  std::vector<float> areas(points.size(), 1.0F);
  if (points.size() > neighbours) {
    parallelBlocks(points.size(), grain, [&] {
      return [&, squares = std::vector<float>(points.size())](std::size_t begin, std::size_t end) mutable {
        for (std::size_t i = begin; i < end; ++i) {
          std::transform(points.begin(), points.end(), squares.begin(), [&](const Vector3& p) {
            const Vector3 apart = p - points[i];
            return dot(apart, apart);
          });
          std::nth_element(squares.begin(), squares.begin() + neighbours,
                           squares.end()); // the nearest is the point itself
          areas[i] = squares[neighbours];
        }
      };
    });
    const float typical = median(areas);
    std::transform(areas.begin(), areas.end(), areas.begin(), [&](float area) { return std::min(area, typical); });
  }
  const float sum = std::accumulate(areas.begin(), areas.end(), 0.0F);
  std::transform(areas.begin(), areas.end(), areas.begin(),
                 [&](float area) { return sum > 0.0F ? area / sum : 1.0F / static_cast<float>(points.size()); });
  return areas;
}

/** Which points belong to pieces, large enough to be parts, whose images do not lie on the surface. */
std::vector<char>
pointsWithoutCounterpart(const PreparedSurface& surface, const PlaneReflection& plane, float tolerance)
{
  constexpr std::size_t grain = 64;
  const SurfaceDistance distance_from(surface, tolerance);
  std::vector<char> is_off(surface.size(), 0);
  parallelFor(
      surface.size(),
      [&](std::size_t v) { is_off[v] = distance_from.at(plane.image(surface.points[v])) <= tolerance ? 0 : 1; }, grain);
  dropSmallParts(surface, SupportSettings{}.least_area, is_off);
  return is_off;
}

std::size_t
countEqualFits(const std::vector<MirrorFit>& planes)
{
  return static_cast<std::size_t>(
      std::count_if(planes.begin(), planes.end(), [](const MirrorFit& fit) { return fit.is_equal; }));
}

/** Lists the maps of the planes, and the rotations that the first one makes with each of the others. */
void
listPlanes(const SampledSurface& sampled,
           const std::vector<MirrorFit>& planes,
           const MirrorSettings& settings,
           std::size_t maximum,
           MapEstimate& estimate)
{
  const std::vector<Index> first = estimate.partners;
  float score = planes.front().residual;
  for (std::size_t k = 0; k < std::min(planes.size(), maximum); ++k) {
    const MirrorFit& fit = planes[k];
    std::vector<Index> partners = mapByPlane(sampled, fit.plane, settings).partners;
    score = std::max(score, fit.residual); // what fits equally well is in no order of residuals
    if (k > 0) {
      std::vector<Index> images = first;
      std::transform(images.begin(), images.end(), images.begin(),
                     [&](Index image) { return image == no_index ? no_index : partners[image]; });
      estimate.rotations.push_back(
          {std::move(images), planes.front().residual + score, std::min(planes.front().share, fit.share), false});
    }
    estimate.alternatives.push_back({std::move(partners), score, fit.share, true});
  }
}

} // namespace

std::vector<MirrorFit>
mirrorPlanesOf(const SampledSurface& sampled, const MirrorSettings& settings)
{
  const CoarseSurface& coarse = sampled.coarse;
  return planesThatFit(sampled.surface, {coarse.points, coarse.normals, coarse.areas}, settings);
}

std::vector<MirrorFit>
mirrorPlanesOf(const PreparedSurface& cloud, std::size_t samples, const MirrorSettings& settings)
{
  AreaSamples even;
  for (const Index v : farthestPointSampling(cloud.graph, farthestFromCentroid(cloud.points), samples).vertices) {
    even.points.push_back(cloud.points[v]);
    even.normals.push_back(cloud.normals[v]);
  }
  even.areas = areasAround(even.points);
  return planesThatFit(cloud, even, settings);
}

bool
haveEqualFits(const std::vector<MirrorFit>& planes)
{
  return countEqualFits(planes) > 1;
}

bool
carriesAll(const MirrorFit& fit, const SampledSurface& sampled, const MirrorSettings& settings)
{
  const std::vector<char> is_off =
      pointsWithoutCounterpart(sampled.surface, fit.plane, toleranceFor(sampled.surface, settings.planes));
  return std::find(is_off.begin(), is_off.end(), 1) == is_off.end();
}

PlaneComparison
compareWithPlane(const SampledSurface& sampled,
                 const SampleEstimate& samples,
                 const MirrorFit& fit,
                 const MirrorSettings& settings)
{
  const PreparedSurface& surface = sampled.surface;
  const SurfaceDistance distance_from(surface, toleranceFor(surface, settings.planes));
  std::vector<Vector3> by_map;
  std::vector<Vector3> by_plane;
  // By hand, and not fitted: between 1.0 to 1.4 of three objects that a search maps front to back, and 2.1 of posed dolls.
  constexpr float much = 1.7F;
  float way_by_map = 0.0F;
  float way_by_plane = 0.0F;
  std::vector<char> is_off(samples.partners.size(), 0);
  for (std::size_t i = 0; i < is_off.size(); ++i) {
    const Vector3 image = fit.plane.image(sampled.coarse.points[i]);
    is_off[i] = std::isfinite(distance_from.at(image)) ? 0 : 1;
    if (is_off[i] == 0) {
      by_map.push_back(surface.points[samples.partners[i]]);
      by_plane.push_back(image);
      way_by_map += sampled.coarse.areas[i] * distance(sampled.coarse.points[i], by_map.back());
      way_by_plane += sampled.coarse.areas[i] * distance(sampled.coarse.points[i], image);
    }
  }
  float rest = 0.0F;
  float kept = 0.0F;
  float exchanged = 0.0F;
  float crossed = 0.0F;
  for (std::size_t i = 0; i < is_off.size(); ++i) {
    if (is_off[i] == 0) {
      continue;
    }
    rest += sampled.coarse.areas[i];
    kept += is_off[samples.map[i]] != 0 ? sampled.coarse.areas[i] : 0.0F;
    const float heights =
        fit.plane.height(sampled.coarse.points[i]) * fit.plane.height(surface.points[samples.partners[i]]);
    crossed += is_off[samples.map[i]] != 0 && heights < 0.0F ? sampled.coarse.areas[i] : 0.0F;
    const Index landmark = sampled.landmarks.nearest_landmark[i];
    // Of two limbs that are posed each is off the other's image; what changes places with the rest is no limb.
    if (is_off[samples.map[i]] != 0 &&
        isExchanged(sampled.landmarks, samples.landmark_map, landmark, limb_separation)) {
      exchanged += sampled.coarse.areas[i];
    }
  }
  const bool exchanges = 2.0F * exchanged > rest;
  const bool is_pose =
      exchanges || (crossed > 0.0F && areRootedAlike(sampled.coarse, is_off, fit.plane, SupportSettings{}.least_area));
  return {!areAlike(by_map, by_plane), way_by_map > much * way_by_plane, exchanges, is_pose, 2.0F * kept > rest};
}

MapEstimate
estimateByMirror(const SampledSurface& sampled,
                 const std::vector<MirrorFit>& planes,
                 const SymmetryParameters& parameters,
                 const MirrorSettings& settings)
{
  const MirrorFit& best = planes.front();
  MirrorMap map = mapByPlane(sampled, best.plane, settings);
  MapEstimate estimate;
  estimate.is_unsupported =
      pointsWithoutCounterpart(sampled.surface, best.plane, toleranceFor(sampled.surface, settings.planes));
  estimate.is_partial =
      std::find(estimate.is_unsupported.begin(), estimate.is_unsupported.end(), 1) != estimate.is_unsupported.end();
  estimate.status = estimate.is_partial ? SymmetryStatus::PartlySymmetric : SymmetryStatus::Symmetric;
  estimate.message = estimate.is_partial ? "a part of the surface has no counterpart" : "";
  estimate.confidence = best.share;
  estimate.map_confidence = best.share;
  estimate.supported_confidence = best.share;
  estimate.trust = best.share;
  estimate.is_by_plane = true;
  estimate.misfit = exact_misfit;
  estimate.diameter = sampled.landmarks.diameter;
  estimate.measures = {{"mirror_share", best.share}, {"mirror_residual", best.residual}};
  const float reach = settings.reach * diagonalOf(sampled.surface);
  for (const float gap : map.gaps) {
    const float support = std::clamp(1.0F - gap / std::max(reach, 1e-6F), 0.0F, 1.0F);
    estimate.support.push_back(support);
    estimate.confidences.push_back(best.share * support);
  }
  estimate.partners = std::move(map.partners);
  estimate.side_function = sidesOfPlane(sampled, best.plane);
  estimate.are_sides_exact = true;
  describeMap(sampled, estimate);
  estimate.equal_reflections = haveEqualFits(planes) ? countEqualFits(planes) : 0;
  if (parameters.alternatives > 1 && !parameters.sparse_only) {
    listPlanes(sampled, planes, settings, static_cast<std::size_t>(parameters.alternatives), estimate);
  }
  return estimate;
}

} // namespace symmetry
} // namespace pcl
