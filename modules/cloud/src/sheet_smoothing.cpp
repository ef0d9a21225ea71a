#include "cloud/sheet_smoothing.h"

#include "base/parallel.h"
#include "base/statistics.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"
#include "cloud/point_grid.h"
#include "kernels/kernels.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr SmoothingSettings settings{};

/** Plane through the mean of the points around a place. */
struct LocalPlane {
  Vector3 mean{};
  Vector3 normal{};
  float thickness = 0.0F; ///< root mean square distance of the points from it
  float support = 0.0F;   ///< sum of the weights
};

float
squaredDistance(const Vector3& a, const Vector3& b)
{
  const Vector3 difference = a - b;
  return dot(difference, difference);
}

/** The points nearer to a place than a radius, which is the edge of the grid's cubes. */
void
gatherAround(const std::vector<Vector3>& points,
             const PointGrid& grid,
             const Vector3& place,
             float radius,
             std::vector<Vector3>& gathered)
{
  gathered.clear();
  grid.visitAround(place, [&](Index i) {
    if (squaredDistance(points[i], place) < radius * radius) {
      gathered.push_back(points[i]);
    }
  });
}

/** Points as the kernel takes them: coordinate by coordinate, padded with what is near no place. */
class CoordinateRows {
public:
  CoordinateRows() = default;

  explicit CoordinateRows(const std::vector<Vector3>& points)
  {
    assign(points);
  }

  void
  assign(const std::vector<Vector3>& points)
  {
    constexpr float far_away = 1e3F; // points are at unit scale
    padded_ = (points.size() + kernel_lanes - 1) / kernel_lanes * kernel_lanes;
    values_.assign(3 * padded_, far_away);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        values_[c * padded_ + i] = points[i][c];
      }
    }
  }

  std::size_t
  padded() const
  {
    return padded_;
  }

  const float*
  data() const
  {
    return values_.data();
  }

private:
  std::size_t padded_ = 0;
  std::vector<float> values_;
};

/** \param[in] slab see slab_moments in kernel_table.h */
LocalPlane
fitPlane(const CoordinateRows& around, const Vector3& place, float radius, const Vector3& slab)
{
  LocalPlane plane{place, {0.0F, 0.0F, 1.0F}, 0.0F, 0.0F};
  std::array<float, slab_moment_count> moments{};
  kernels().slab_moments(around.data(), around.padded(), place.data(), radius, slab.data(), moments.data());
  plane.support = moments[0];
  if (plane.support <= 0.0F) {
    return plane;
  }
  for (float& moment : moments) {
    moment /= plane.support;
  }
  const Eigen::Vector3f mean(moments[1], moments[2], moments[3]);
  Eigen::Matrix3f covariance;
  covariance << moments[4], moments[5], moments[6], moments[5], moments[7], moments[8], moments[6], moments[8],
      moments[9];
  covariance -= mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3f normal = solver.eigenvectors().col(0);
  if (normal.allFinite()) {
    plane.normal = normalized({normal.x(), normal.y(), normal.z()});
  }
  plane.mean = place + radius * Vector3{mean.x(), mean.y(), mean.z()};
  plane.thickness = radius * std::sqrt(std::max(0.0F, solver.eigenvalues()(0)));
  return plane;
}

/** Plane through all points around a place; the farther they are, the less they count. */
LocalPlane
fitPlane(const CoordinateRows& around, const Vector3& place, float radius)
{
  return fitPlane(around, place, radius, Vector3{});
}

/** Plane through those points around a place that are on its own sheet of the surface: points also count the less the
 * farther they are from the plane through the place, and from \a width on not at all. */
LocalPlane
fitSheet(const CoordinateRows& around, const Vector3& place, const Vector3& normal, float radius, float width)
{
  return fitPlane(around, place, radius, (radius / width) * normal);
}

/** Every so many-th point, so that about \a count are left; all if there are no more. */
std::vector<Vector3>
everyFew(const std::vector<Vector3>& points, std::size_t count)
{
  const std::size_t stride = std::max<std::size_t>(1, points.size() / std::max<std::size_t>(1, count));
  std::vector<Vector3> chosen;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    chosen.push_back(points[i]);
  }
  return chosen;
}

/** Thickness of neighbourhoods over their radius; a ball has 0.33. */
std::vector<float>
relativeThickness(const std::vector<Vector3>& points, float radius, std::size_t probes)
{
  const PointGrid grid(points, radius);
  std::vector<float> thickness;
  std::vector<Vector3> around;
  for (const Vector3& place : everyFew(points, probes)) {
    gatherAround(points, grid, place, radius, around);
    thickness.push_back(fitPlane(CoordinateRows(around), place, radius).thickness / radius);
  }
  return thickness;
}

/** The part of the relative thickness of neighbourhoods that is not curvature.
 *
 * Off the plane of a neighbourhood of radius r noise of standard deviation s is by s, a surface of curvature c by a share
 * of c r^2. Their squares add up, so that two radii tell them apart: over the radius noise falls as r grows, curvature
 * rises. */
float
noiseThickness(const std::vector<Vector3>& points, float radius)
{
  const float first = quantile(relativeThickness(points, radius, settings.noise_probes), settings.flat_share);
  const float step = settings.radius_step * settings.radius_step;
  if (first < settings.flat) { // with curvature, and without it less
    return first;
  }
  const float second =
      quantile(relativeThickness(points, settings.radius_step * radius, settings.noise_probes), settings.flat_share);
  const float squared = (first * first - second * second / step) / (1.0F - 1.0F / (step * step));
  return std::sqrt(std::max(0.0F, squared));
}

/** Number of points within a radius that nine of ten neighbourhoods have. */
std::size_t
fewestAround(const std::vector<Vector3>& points, float radius)
{
  const PointGrid grid(points, radius);
  std::vector<std::size_t> numbers;
  std::vector<Vector3> around;
  for (const Vector3& place : everyFew(points, settings.number_probes)) {
    gatherAround(points, grid, place, radius, around);
    numbers.push_back(around.size());
  }
  return quantile(std::move(numbers), 0.1);
}

/** Moves a place onto its sheet; the share of the weight of all points around that is within the sheet.
 * \param[out] normal of the sheet, of either sign */
float
moveToSheet(Vector3& place, Vector3& normal, const CoordinateRows& around, float radius, float width)
{
  const LocalPlane all = fitPlane(around, place, radius);
  LocalPlane sheet = all;
  for (int round = 0; round < settings.rounds; ++round) {
    sheet = fitSheet(around, place, sheet.normal, radius, width);
    place = place - dot(place - sheet.mean, sheet.normal) * sheet.normal;
  }
  normal = sheet.normal;
  return all.support > 0.0F ? sheet.support / all.support : 0.0F;
}

/** The points of a cloud around places: within the least radius where there are enough, else within the radius
 * around as many, but at most the largest one. */
class Neighbourhoods {
public:
  Neighbourhoods(const std::vector<Vector3>& points, const Smoothing& smoothing)
      : points_(points), smoothing_(smoothing), near_(points, smoothing.least_radius), far_(points, smoothing.radius)
  {
  }

  /** \param[out] around the points; their radius is returned */
  float
  gather(const Vector3& place, std::vector<Vector3>& around) const
  {
    gatherAround(points_, near_, place, smoothing_.least_radius, around);
    if (around.size() >= settings.minimum_points || smoothing_.least_radius >= smoothing_.radius) {
      return smoothing_.least_radius;
    }
    gatherAround(points_, far_, place, smoothing_.radius, around);
    if (around.size() <= settings.minimum_points) {
      return smoothing_.radius;
    }
    const auto last = around.begin() + static_cast<std::ptrdiff_t>(settings.minimum_points);
    std::nth_element(around.begin(), last, around.end(), [&](const Vector3& a, const Vector3& b) {
      const float da = squaredDistance(a, place);
      const float db = squaredDistance(b, place);
      return da != db ? da < db : a < b;
    });
    const float radius = distance(*last, place);
    around.erase(last, around.end());
    return radius;
  }

private:
  const std::vector<Vector3>& points_;
  const Smoothing& smoothing_;
  PointGrid near_;
  PointGrid far_;
};

} // namespace

Smoothing
findSmoothing(const std::vector<Vector3>& points, float spacing)
{
  Smoothing best;
  const float first_radius = settings.first_radius * spacing;
  if (!(first_radius > 0.0F && first_radius < settings.maximum_radius) ||
      noiseThickness(points, first_radius) < settings.flat) {
    return best;
  }
  float flattest = std::numeric_limits<float>::infinity();
  float radius = first_radius;
  while (radius < settings.maximum_radius) {
    const float thickness = median(relativeThickness(points, radius, settings.thickness_probes));
    if (thickness < flattest) {
      flattest = thickness;
      const float smoothing_radius = std::max(settings.certain_radius * radius, settings.minimum_spacings * spacing);
      best = {smoothing_radius, smoothing_radius, settings.width_of_thickness * thickness * radius,
              radius / settings.spacings_per_radius};
    }
    radius *= settings.radius_step;
  }
  return best;
}

Smoothing
withLeastRadius(Smoothing smoothing, float spacing)
{
  constexpr float disc = 1.128F; // 2 / sqrt (pi)
  if (smoothing.radius <= 0.0F) {
    return smoothing;
  }
  // Where neighbourhoods are flattest, noise and curvature have equal parts in their thickness.
  const float noise = smoothing.width / (settings.width_of_thickness * std::sqrt(2.0F));
  // The normal of a plane fitted to n points with noise s in a disc of radius r is off by 2 s / (r sqrt (n)), and n is
  // pi (r / spacing)^2.
  const float certain = std::sqrt(disc * noise * spacing / settings.normal_tolerance);
  smoothing.least_radius = std::min(smoothing.radius, std::max(certain, settings.minimum_spacings * spacing));
  smoothing.spacing = std::min(smoothing.spacing, smoothing.least_radius / settings.spacings_per_radius);
  return smoothing;
}

SheetPlaces
moveToSheets(std::vector<Vector3> places, const std::vector<Vector3>& points, const Smoothing& smoothing)
{
  constexpr float pi = 3.14159265F;
  SheetPlaces sheets;
  sheets.places = std::move(places);
  sheets.normals.resize(sheets.places.size());
  sheets.gaps.resize(sheets.places.size());
  sheets.support.resize(sheets.places.size());
  const std::size_t times_enough =
      std::max<std::size_t>(1, fewestAround(points, smoothing.radius) / settings.plane_points);
  const std::vector<Vector3> thinned = everyFew(points, points.size() / times_enough);
  const Neighbourhoods neighbourhoods(thinned, smoothing);
  constexpr std::size_t grain = 64;
  parallelBlocks(sheets.places.size(), grain, [&] {
    return [&, around = std::vector<Vector3>(), rows = CoordinateRows()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t v = begin; v < end; ++v) {
        const float radius = neighbourhoods.gather(sheets.places[v], around);
        const auto number = static_cast<float>(std::max<std::size_t>(1, around.size()));
        rows.assign(everyFew(around, settings.plane_points));
        const float share = moveToSheet(sheets.places[v], sheets.normals[v], rows, radius, smoothing.width);
        const float to_radius = smoothing.radius / radius;
        sheets.gaps[v] = radius * std::sqrt(pi / number);
        sheets.support[v] = share < settings.minimum_share ? 0.0F : share * number * to_radius * to_radius;
      }
    };
  });
  return sheets;
}

} // namespace symmetry
} // namespace pcl
