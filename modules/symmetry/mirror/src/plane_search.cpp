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
#include <numeric>
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
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(); ///< covariance
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
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d offset = toEigen(samples.points[i]) - inertia.centroid;
    inertia.spread += double{samples.areas[i]} * offset * offset.transpose();
  }
  inertia.spread /= total;
  inertia.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia.spread).eigenvectors();
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

/** Planes in all directions, by how near to the surface they send the first samples, so many; the best first.
 * \param[in] shifts of the planes from the centroid, in standard deviations along their normals
 * \param[in] farthest no image counts as farther off */
std::vector<RatedPlane>
ratePlanes(const AreaSamples& samples,
           const PlaneSearchSettings& settings,
           std::size_t count,
           const std::vector<float>& shifts,
           float farthest)
{
  const Inertia inertia = inertiaOf(samples);
  const DistanceGrid grid(samples.points, grid_cells);
  const std::size_t rated_samples = std::min(count, samples.size());
  const float area =
      std::accumulate(samples.areas.begin(), samples.areas.begin() + static_cast<std::ptrdiff_t>(rated_samples), 0.0F);
  std::vector<RatedPlane> rated;
  for (const Vector3& direction : directionsOverHalfSphere(inertia.axes, settings.directions)) {
    const Eigen::Vector3d normal = toEigen(direction);
    const double deviation = std::sqrt(std::max(0.0, normal.dot(inertia.spread * normal)));
    for (const float shift : shifts) {
      const PlaneReflection plane{direction,
                                  static_cast<float>(normal.dot(inertia.centroid) + double{shift} * deviation)};
      float cost = 0.0F;
      for (std::size_t i = 0; i < rated_samples; ++i) {
        cost += samples.areas[i] * std::min(farthest, grid.at(plane.image(samples.points[i])));
      }
      rated.push_back({plane, cost / std::max(area, 1e-12F)});
    }
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

/** Aligns planes and keeps those that fit; what it needs to do so is prepared once. */
class PlaneFitting {
public:
  /** All that is given is referred to, not copied. */
  PlaneFitting(const AreaSamples& samples, const PreparedSurface& surface, const PlaneSearchSettings& settings)
      : samples_(samples),
        surface_(surface),
        settings_(settings),
        diagonal_(static_cast<float>(boundingBox(surface.points).diagonal())),
        tolerance_(settings.tolerance * diagonal_),
        distance_from_(surface, tolerance_),
        alignment_(samples, {samples.points, samples.normals}, onto_samples, diagonal_),
        polish_(samples, {surface.points, surface.normals}, onto_points, diagonal_)
  {
  }

  /** Mean distance from which on planes are not promising. */
  float
  hopeless() const
  {
    return settings_.hopeless * diagonal_;
  }

  /** Tries the most promising of planes. */
  void
  tryPlanes(const std::vector<RatedPlane>& rated)
  {
    for (const PlaneReflection& plane : promisingPlanes(rated, settings_, hopeless())) {
      if (const std::optional<MirrorFit> fit = fitOf(plane)) {
        keep(*fit);
      }
    }
  }

  /** Whether any plane would seem to fit. */
  bool
  isTooFull() const
  {
    return chance_ > too_full;
  }

  /** Planes of the whole, or the best of a part; none where the surface fills space. */
  std::vector<MirrorFit>
  take()
  {
    if (isTooFull()) {
      return {};
    }
    if (fits_.empty() && of_part_) {
      of_part_->is_of_part = true;
      fits_.push_back(*of_part_);
    }
    orderByFit(fits_, settings_, tolerance_);
    return std::move(fits_);
  }

  bool
  hasWhole() const
  {
    return !fits_.empty();
  }

private:
  MirrorFit
  look(const PlaneReflection& plane, std::size_t count) const
  {
    return measureFit(plane, samples_, distance_from_, tolerance_, count);
  }

  /** Whether more than a share of the area agrees, beyond chance (J. Cohen's kappa, 1960 \cite cohen1960agreement). */
  bool
  agrees(const MirrorFit& fit, float share) const
  {
    return fit.share - *chance_ >= share * (1.0F - *chance_);
  }

  std::optional<MirrorFit>
  fitOf(const PlaneReflection& plane)
  {
    MirrorFit fit = look(alignment_.run(plane, settings_.rounds), first_look);
    if (fit.share < settings_.promising_share) {
      return std::nullopt; // as nearly all are, for a small part of the cost
    }
    if (!chance_) {
      chance_ = shareByChance(samples_, distance_from_, tolerance_);
    }
    if (isTooFull() || !agrees(fit, settings_.promising_share)) {
      return std::nullopt;
    }
    const MirrorFit polished = look(polish_.run(fit.plane, settings_.rounds), first_look);
    fit = look(polished.residual < fit.residual ? polished.plane : fit.plane, samples_.size());
    if (fit.share < settings_.good_share) {
      if (!fitting_) {
        fitting_.emplace(samples_, surface_, onto_surface, diagonal_);
      }
      const MirrorFit fitted = look(fitting_->run(fit.plane, settings_.rounds), samples_.size());
      fit = fitted.residual < fit.residual ? fitted : fit;
    }
    return fit;
  }

  void
  keep(const MirrorFit& fit)
  {
    if (fit.displacement < settings_.least_displacement * diagonal_) {
      return;
    }
    if (!agrees(fit, settings_.least_share)) {
      if (isExact(fit, settings_, tolerance_) && (!of_part_ || fit.share > of_part_->share)) {
        of_part_ = fit;
      }
    }
    else if (std::all_of(fits_.begin(), fits_.end(), [&](const MirrorFit& other) {
               return areDistinct(fit.plane, other.plane, settings_.distinct);
             })) {
      fits_.push_back(fit);
    }
  }

  const AreaSamples& samples_;
  const PreparedSurface& surface_;
  const PlaneSearchSettings& settings_;
  float diagonal_;
  float tolerance_;
  SurfaceDistance distance_from_;
  PointAlignment alignment_;
  PointAlignment polish_;
  std::optional<SurfaceAlignment> fitting_; ///< made where there is need
  std::optional<float> chance_;             ///< known where there is need
  std::vector<MirrorFit> fits_;
  std::optional<MirrorFit> of_part_; ///< the largest
};

} // namespace

std::vector<MirrorFit>
findMirrorPlanes(const AreaSamples& samples, const PreparedSurface& surface, const PlaneSearchSettings& settings)
{
  PlaneFitting fitting(samples, surface, settings);
  fitting.tryPlanes(ratePlanes(samples, settings, samples.size(), {0.0F}, std::numeric_limits<float>::infinity()));
  // A mesh in one part is a body, more likely than an object: its map is found along the surface.
  const bool may_be_object = surface.is_cloud || !surface.part_of.empty();
  if (may_be_object && !fitting.hasWhole() && !fitting.isTooFull() && settings.exact_residual > 0.0F) {
    // What is fitted on pulls the centroid out of the plane of the rest, a fifth of the area by two fifths of a deviation
    // where it is two of them away; and its image is as far off as it likes. The alignment reaches over half of such a shift
    // (by hand).
    const float farthest = fitting.hopeless() / (1.0F - settings.promising_share);
    fitting.tryPlanes(ratePlanes(samples, settings, first_look, {-0.4F, -0.2F, 0.0F, 0.2F, 0.4F}, farthest));
  }
  return fitting.take();
}

} // namespace symmetry
} // namespace pcl
