#include "symmetry/mirror/plane_search.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "cloud/point_grid.h"
#include "symmetry/mirror/distance_grid.h"
#include "symmetry/mirror/plane_alignment.h"
#include "symmetry/mirror/surface_distance.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t grid_cells = 48;  // a cube is about as wide as samples are apart
constexpr std::size_t first_look = 200; // samples: a share is known to 3 %
constexpr float too_full = 0.5F;        // share that lies on the surface by chance: nothing can be told any more
constexpr double pi = 3.14159265358979323846;

/** Centroid and axes of inertia of samples that stand for their areas. */
struct Inertia {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

Inertia
inertiaOf(const AreaSamples& samples)
{
  Inertia inertia;
  double total = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    inertia.centroid += double{samples.areas[i]} * toEigen(samples.points[i]);
    total += samples.areas[i];
  }
  inertia.centroid /= total;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d offset = toEigen(samples.points[i]) - inertia.centroid;
    spread += double{samples.areas[i]} * offset * offset.transpose();
  }
  inertia.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  return inertia;
}

/** Directions over half a sphere: the axes of inertia, one of which the normal of a mirror plane is unless two moments
 * are equal, and a Fibonacci lattice in their frame, so that a rigid motion takes the directions along. */
std::vector<Vector3>
directionsOverHalfSphere(const Eigen::Matrix3d& axes, std::size_t count)
{
  const double golden_angle = pi * (3.0 - std::sqrt(5.0));
  std::vector<Vector3> directions;
  directions.reserve(count + 3);
  for (int k = 0; k < 3; ++k) {
    directions.push_back(fromEigen(axes.col(k)));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double radius = std::sqrt(1.0 - z * z);
    const double angle = golden_angle * static_cast<double>(i);
    directions.push_back(fromEigen(axes * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z)));
  }
  return directions;
}

struct RatedPlane {
  PlaneReflection plane;
  float cost = 0.0F;
};

bool
areDistinct(const PlaneReflection& a, const PlaneReflection& b, float angle)
{
  return std::abs(dot(a.normal, b.normal)) < std::cos(angle);
}

/** The directions whose planes through the centroid send the samples nearest to the surface, the best first. */
std::vector<RatedPlane>
rateDirections(const AreaSamples& samples, const PlaneSearchSettings& settings)
{
  const Inertia inertia = inertiaOf(samples);
  const DistanceGrid grid(samples.points, grid_cells);
  std::vector<RatedPlane> rated;
  for (const Vector3& direction : directionsOverHalfSphere(inertia.axes, settings.directions)) {
    const PlaneReflection plane{direction, static_cast<float>(toEigen(direction).dot(inertia.centroid))};
    float cost = 0.0F;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      cost += samples.areas[i] * grid.at(plane.image(samples.points[i]));
    }
    rated.push_back({plane, cost});
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const RatedPlane& a, const RatedPlane& b) { return a.cost < b.cost; });
  return rated;
}

/** Those of planes, best first, that are better than all around them: where one fits, those a little off do not crowd
 * out the others. */
std::vector<PlaneReflection>
promisingPlanes(const std::vector<RatedPlane>& rated, const PlaneSearchSettings& settings, float hopeless)
{
  std::vector<PlaneReflection> chosen;
  for (auto it = rated.begin(); it != rated.end() && chosen.size() < settings.aligned && it->cost <= hopeless; ++it) {
    if (std::all_of(rated.begin(), it, [&](const RatedPlane& better) {
          return areDistinct(it->plane, better.plane, settings.distinct);
        })) {
      chosen.push_back(it->plane);
    }
  }
  return chosen;
}

/** The planes that fit as well as the best one first, among them those that most is far from, the others by their fit. */
void
orderByFit(std::vector<MirrorFit>& fits, const PlaneSearchSettings& settings, float tolerance)
{
  std::stable_sort(fits.begin(), fits.end(),
                   [](const MirrorFit& a, const MirrorFit& b) { return a.residual < b.residual; });
  for (MirrorFit& fit : fits) {
    fit.is_equal = fit.residual <= fits.front().residual + settings.equal_residual * tolerance &&
                   std::abs(fit.share - fits.front().share) <= settings.equal_share;
  }
  const auto others =
      std::stable_partition(fits.begin(), fits.end(), [](const MirrorFit& fit) { return fit.is_equal; });
  std::stable_sort(fits.begin(), others,
                   [](const MirrorFit& a, const MirrorFit& b) { return a.displacement > b.displacement; });
}

/** How well the first samples, so many, are carried onto the surface. */
MirrorFit
measureFit(const PlaneReflection& plane,
           const AreaSamples& samples,
           const SurfaceDistance& distance_from,
           float tolerance,
           std::size_t count)
{
  MirrorFit fit{plane};
  float area = 0.0F;
  for (std::size_t i = 0; i < std::min(count, samples.size()); ++i) {
    heartbeat();
    const float apart = distance_from.at(plane.image(samples.points[i]));
    area += samples.areas[i];
    fit.share += apart <= tolerance ? samples.areas[i] : 0.0F;
    fit.residual += samples.areas[i] * std::min(apart, tolerance);
    fit.displacement += samples.areas[i] * std::abs(plane.height(samples.points[i]));
  }
  for (float* measure : {&fit.share, &fit.residual, &fit.displacement}) {
    *measure /= std::max(area, 1e-12F);
  }
  return fit;
}

/** Share of the samples that still lie on the surface when they are moved off it, along their normals: next to nothing of an
 * object, nearly all where faces fill space, so that any plane seems to fit. The least of several ways, since one may be
 * the thickness of a wall. */
float
shareByChance(const AreaSamples& samples, const SurfaceDistance& distance_from, float tolerance)
{
  float least = 1.0F;
  for (const float way : {3.0F, 5.0F, 8.0F, -3.0F, -5.0F, -8.0F}) {
    float on_surface = 0.0F;
    float area = 0.0F;
    for (std::size_t i = 0; i < std::min(first_look, samples.size()); ++i) {
      heartbeat();
      const Vector3 place = samples.points[i] + (way * tolerance) * samples.normals[i];
      area += samples.areas[i];
      on_surface += distance_from.at(place) <= tolerance ? samples.areas[i] : 0.0F;
    }
    least = std::min(least, on_surface / std::max(area, 1e-12F));
  }
  return least;
}

/** Whether what lies on the surface does so exactly, see PlaneSearchSettings::exact_residual. */
bool
isExact(const MirrorFit& fit, const PlaneSearchSettings& settings, float tolerance)
{
  const float of_rest = 1.0F - fit.share; // each counts a whole tolerance
  return fit.residual / tolerance - of_rest <= settings.exact_residual * fit.share;
}

} // namespace

std::vector<MirrorFit>
findMirrorPlanes(const AreaSamples& samples, const PreparedSurface& surface, const PlaneSearchSettings& settings)
{
  const auto diagonal = static_cast<float>(boundingBox(surface.points).diagonal());
  const std::vector<PlaneReflection> chosen =
      promisingPlanes(rateDirections(samples, settings), settings, settings.hopeless * diagonal);
  const float tolerance = settings.tolerance * diagonal;
  const SurfaceDistance distance_from(surface, tolerance);
  const auto look = [&](const PlaneReflection& plane, std::size_t count) {
    return measureFit(plane, samples, distance_from, tolerance, count);
  };
  const PointAlignment alignment(samples, {samples.points, samples.normals}, onto_samples, diagonal);
  const PointAlignment polish(samples, {surface.points, surface.normals}, onto_points, diagonal);
  std::optional<SurfaceAlignment> fitting; // made where there is need
  std::optional<float> chance;             // known where there is need
  std::vector<MirrorFit> fits;
  std::optional<MirrorFit> of_part; // the largest
  for (const PlaneReflection& plane : chosen) {
    MirrorFit fit = look(alignment.run(plane, settings.rounds), first_look);
    if (fit.share < settings.promising_share) {
      continue; // as nearly all are, for a small part of the cost
    }
    if (!chance) {
      chance = shareByChance(samples, distance_from, tolerance);
    }
    if (*chance > too_full) {
      return {};
    }
    if (fit.share - *chance < settings.promising_share * (1.0F - *chance)) {
      continue; // agreement beyond chance is what counts (J. Cohen's kappa, 1960 \cite cohen1960agreement)
    }
    const MirrorFit polished = look(polish.run(fit.plane, settings.rounds), first_look);
    fit = look(polished.residual < fit.residual ? polished.plane : fit.plane, samples.size());
    if (fit.share < settings.good_share) {
      if (!fitting) {
        fitting.emplace(samples, surface, onto_surface, diagonal);
      }
      const MirrorFit fitted = look(fitting->run(fit.plane, settings.rounds), samples.size());
      fit = fitted.residual < fit.residual ? fitted : fit;
    }
    if (fit.displacement < settings.least_displacement * diagonal) {
      continue;
    }
    if (fit.share - *chance < settings.least_share * (1.0F - *chance)) {
      if (isExact(fit, settings, tolerance) && (!of_part || fit.share > of_part->share)) {
        of_part = fit;
      }
    }
    else if (std::all_of(fits.begin(), fits.end(), [&](const MirrorFit& other) {
               return areDistinct(fit.plane, other.plane, settings.distinct);
             })) {
      fits.push_back(fit);
    }
  }
  if (fits.empty() && of_part) {
    of_part->is_of_part = true;
    fits.push_back(*of_part);
  }
  orderByFit(fits, settings, tolerance);
  return fits;
}

} // namespace symmetry
} // namespace pcl
