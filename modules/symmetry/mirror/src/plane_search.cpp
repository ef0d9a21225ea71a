#include "symmetry/mirror/plane_search.h"

#include "base/bounding_box.h"
#include "cloud/point_grid.h"
#include "symmetry/mirror/distance_grid.h"
#include "symmetry/mirror/surface_distance.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t grid_cells = 48;  // a cube is about as wide as samples are apart
constexpr std::size_t first_look = 200; // samples: a share is known to 3 %
constexpr double pi = 3.14159265358979323846;

Eigen::Vector3d
toEigen(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

Vector3
fromEigen(const Eigen::Vector3d& v)
{
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

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

/** How the images of samples are drawn onto the points nearest to them. Lengths are shares of the diagonal. */
struct AlignmentSettings {
  float reach;
  float first_scale; ///< of the gaps that still count,
  float last_scale;  ///< falling from round to round
  double slide;      ///< weight of gaps along the surface next to those across it
};

/** From a direction 6 degrees off to what is left between samples; they slide along the surface (Chen and Medioni). */
constexpr AlignmentSettings onto_samples{0.1F, 0.04F, 0.005F, 0.1};
/** From there to the points themselves: where points were mirrored too, the gaps vanish. */
constexpr AlignmentSettings onto_points{0.02F, 0.01F, 0.001F, 1.0};

/** Points that images are drawn onto. */
struct AlignmentTargets {
  const std::vector<Vector3>& points;
  const std::vector<Vector3>& normals;
};

class Alignment {
public:
  Alignment(const AreaSamples& samples,
            const AlignmentTargets& targets,
            const AlignmentSettings& settings,
            float diagonal)
      : samples_(samples),
        targets_(targets),
        settings_(settings),
        diagonal_(diagonal),
        grid_(targets.points, settings.reach * diagonal)
  {
  }

  /** Steps of Gauss and Newton that close the gaps between the images and the points nearest to them. */
  PlaneReflection
  run(PlaneReflection plane, int rounds) const
  {
    for (int round = 0; round < rounds; ++round) {
      const float part = static_cast<float>(round) / static_cast<float>(std::max(1, rounds - 1));
      plane =
          step(plane, diagonal_ * settings_.first_scale * std::pow(settings_.last_scale / settings_.first_scale, part));
    }
    return plane;
  }

private:
  static constexpr std::size_t sources = 500; // the first samples are spread over the whole surface

  Index
  nearestTarget(const Vector3& place) const
  {
    Index best = no_index;
    float least = settings_.reach * diagonal_;
    grid_.visitAround(place, [&](Index v) {
      const float apart = distance(targets_.points[v], place);
      if (apart < least) {
        least = apart;
        best = v;
      }
    });
    return best;
  }

  PlaneReflection
  step(const PlaneReflection& plane, float scale) const
  {
    const Eigen::Vector3d normal = toEigen(plane.normal);
    const Eigen::Vector3d t1 = normal.unitOrthogonal();
    const Eigen::Vector3d t2 = normal.cross(t1);
    Eigen::Matrix3d system = 1e-9 * Eigen::Matrix3d::Identity(); // regular also where hardly a gap counts
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < std::min(sources, samples_.size()); ++i) {
      const Vector3 image = plane.image(samples_.points[i]);
      const Index q = nearestTarget(image);
      if (q == no_index) {
        continue;
      }
      const Eigen::Vector3d gap = toEigen(image - targets_.points[q]);
      const Eigen::Vector3d facing = toEigen(targets_.normals[q]);
      const Eigen::Matrix3d metric =
          (1.0 - settings_.slide) * facing * facing.transpose() + settings_.slide * Eigen::Matrix3d::Identity();
      // The weights of the robust estimator of Geman and McClure.
      const double size = gap.dot(metric * gap) / (double{scale} * double{scale});
      const double weight = double{samples_.areas[i]} / ((1.0 + size) * (1.0 + size));
      // How the image moves with the offset and with turns of the normal towards t1 and t2.
      const Eigen::Vector3d p = toEigen(samples_.points[i]);
      const double height = plane.height(samples_.points[i]);
      Eigen::Matrix3d motion;
      motion.col(0) = 2.0 * normal;
      motion.col(1) = -2.0 * (t1.dot(p) * normal + height * t1);
      motion.col(2) = -2.0 * (t2.dot(p) * normal + height * t2);
      system += weight * motion.transpose() * metric * motion;
      right -= weight * motion.transpose() * metric * gap;
    }
    const Eigen::Vector3d change = system.ldlt().solve(right);
    const Eigen::Vector3d turned = (normal + change[1] * t1 + change[2] * t2).normalized();
    return {fromEigen(turned), static_cast<float>(plane.offset + change[0])};
  }

  const AreaSamples& samples_;
  AlignmentTargets targets_;
  AlignmentSettings settings_;
  float diagonal_;
  PointGrid grid_;
};

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
    float displacement = 0.0F;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      cost += samples.areas[i] * grid.at(plane.image(samples.points[i]));
      displacement += samples.areas[i] * std::abs(plane.height(samples.points[i]));
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
  const Alignment alignment(samples, {samples.points, samples.normals}, onto_samples, diagonal);
  const Alignment polish(samples, {surface.points, surface.normals}, onto_points, diagonal);
  std::vector<MirrorFit> fits;
  for (const PlaneReflection& plane : chosen) {
    MirrorFit fit = look(alignment.run(plane, settings.rounds), first_look);
    if (fit.share < settings.promising_share) {
      continue; // as nearly all are, for a small part of the cost
    }
    const MirrorFit polished = look(polish.run(fit.plane, settings.rounds), first_look);
    fit = look(polished.residual < fit.residual ? polished.plane : fit.plane, samples.size());
    if (fit.share >= settings.least_share && fit.displacement >= settings.least_displacement * diagonal &&
        std::all_of(fits.begin(), fits.end(),
                    [&](const MirrorFit& other) { return areDistinct(fit.plane, other.plane, settings.distinct); })) {
      fits.push_back(fit);
    }
  }
  orderByFit(fits, settings, tolerance);
  return fits;
}

} // namespace symmetry
} // namespace pcl
