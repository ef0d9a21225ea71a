#include "cloud/working_cloud.h"

#include "cloud/point_grid.h"
#include "geodesic/parallel.h"
#include "geodesic/vector_math.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

float
median(std::vector<float> values)
{
  if (values.empty()) {
    return 0.0F;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Mean distance of every point to its neighbours. */
std::vector<float>
neighbourDistances(const std::vector<Vector3>& points, const NeighbourLists& lists)
{
  std::vector<float> mean(points.size(), 0.0F);
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::size_t found = 0;
    for (std::size_t i = v * lists.k; i < (v + 1) * lists.k && lists.neighbours[i] != no_index; ++i, ++found) {
      mean[v] += distance(points[v], points[lists.neighbours[i]]);
    }
    mean[v] /= static_cast<float>(std::max<std::size_t>(found, 1));
  }
  return mean;
}

/** Points whose neighbours are, in the lower quartile, several times closer to theirs. */
std::vector<char>
findOutliers(const NeighbourLists& lists, const std::vector<float>& mean_distance)
{
  constexpr float farther = 3.0F;
  std::vector<char> outlier(mean_distance.size(), 0);
  std::vector<float> around;
  for (std::size_t v = 0; v < mean_distance.size(); ++v) {
    around.clear();
    for (std::size_t i = v * lists.k; i < (v + 1) * lists.k && lists.neighbours[i] != no_index; ++i) {
      if (static_cast<std::size_t>(lists.neighbours[i]) != v) {
        around.push_back(mean_distance[lists.neighbours[i]]);
      }
    }
    if (!around.empty()) {
      const auto quartile = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 4);
      std::nth_element(around.begin(), quartile, around.end());
      outlier[v] = static_cast<char>(*quartile > 0.0F && mean_distance[v] > farther * *quartile);
    }
  }
  return outlier;
}

/** Plane through the mean of the points around a place, each weighted by its distance from the place. */
struct LocalPlane {
  Vector3 mean{};
  Vector3 normal{};
  float thickness = 0.0F; ///< root mean square distance of the points from it
  float support = 0.0F;   ///< sum of the weights
};

LocalPlane
fitPlane(const std::vector<Vector3>& points, const PointGrid& grid, const Vector3& place, float radius)
{
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  float total = 0.0F;
  grid.visitAround(place, [&](Index i) {
    const Vector3 offset = (1.0F / radius) * (points[i] - place);
    const float squared = dot(offset, offset);
    if (squared < 1.0F) {
      const float weight = (1.0F - squared) * (1.0F - squared);
      const Eigen::Vector3f x(offset[0], offset[1], offset[2]);
      mean += weight * x;
      covariance += weight * x * x.transpose();
      total += weight;
    }
  });
  LocalPlane plane{place, {0.0F, 0.0F, 1.0F}, 0.0F};
  if (total <= 0.0F) {
    return plane;
  }
  plane.support = total;
  mean /= total;
  covariance = covariance / total - mean * mean.transpose();
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

/** Median thickness of neighbourhoods over their radius; a ball has 0.33. */
float
relativeThickness(const std::vector<Vector3>& points, float radius)
{
  constexpr std::size_t probes = 600;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / probes);
  const PointGrid grid(points, radius);
  std::vector<float> thickness;
  for (std::size_t v = 0; v < points.size(); v += stride) {
    thickness.push_back(fitPlane(points, grid, points[v], radius).thickness / radius);
  }
  return median(std::move(thickness));
}

/** Radius at which neighbourhoods are flattest for their size: below it noise makes them thick, above it the curvature
 * of the surface. 0 where there is no noise to speak of: they are flat at the spacing, or hardly thick there and, since
 * that comes from curvature, thicker at once above it. */
float
smoothingRadius(const std::vector<Vector3>& points, float spacing)
{
  constexpr float first = 2.2F;    // spacings; with fewer points around, any plane fits
  constexpr float largest = 0.06F; // of the longest side
  constexpr float step = 1.25F;
  constexpr float flat = 0.09F;
  float best = 0.0F;
  float flattest = std::numeric_limits<float>::infinity();
  for (float radius = first * spacing; radius > 0.0F && radius < largest; radius *= step) {
    const float thickness = relativeThickness(points, radius);
    if (best == 0.0F && thickness < flat) {
      return 0.0F;
    }
    if (thickness < flattest) {
      flattest = thickness;
      best = radius;
    }
  }
  constexpr float step_up = 1.25F; // with more points the planes gain in certainty more than they lose
  return step_up * best;
}

/** Numbers of points no two of which are closer than a spacing, and all others are within it of one of them. */
std::vector<Index>
thinOut(const std::vector<Vector3>& points, float spacing)
{
  const PointGrid grid(points, spacing);
  std::vector<char> covered(points.size(), 0);
  std::vector<Index> kept;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (covered[v] != 0) {
      continue;
    }
    kept.push_back(static_cast<Index>(v));
    grid.visitAround(points[v], [&](Index i) {
      if (distance(points[i], points[v]) < spacing) {
        covered[i] = 1;
      }
    });
  }
  return kept;
}

/** Nearest kept point of every point, at most a spacing away. */
std::vector<Index>
nearestKept(const std::vector<Vector3>& points, const std::vector<Index>& kept, float spacing, unsigned threads)
{
  std::vector<Vector3> places;
  places.reserve(kept.size());
  for (const Index v : kept) {
    places.push_back(points[v]);
  }
  const PointGrid grid(places, spacing);
  std::vector<Index> nearest(points.size(), no_index);
  constexpr std::size_t grain = 1024;
  parallelFor(
      points.size(), threads,
      [&](std::size_t v) {
        float least = std::numeric_limits<float>::infinity();
        grid.visitAround(points[v], [&](Index i) {
          const float d = distance(places[i], points[v]);
          if (d < least) {
            least = d;
            nearest[v] = i;
          }
        });
      },
      grain);
  return nearest;
}

/** Moves points onto the planes around them; twice, as the planes of places off the surface are tilted. The support of
 * each. */
std::vector<float>
smooth(std::vector<Vector3>& working, const std::vector<Vector3>& all, float radius, unsigned threads)
{
  std::vector<float> support(working.size());
  const PointGrid grid(all, radius);
  constexpr std::size_t grain = 256;
  parallelFor(
      working.size(), threads,
      [&](std::size_t v) {
        for (int round = 0; round < 2; ++round) {
          const LocalPlane plane = fitPlane(all, grid, working[v], radius);
          working[v] = working[v] - dot(working[v] - plane.mean, plane.normal) * plane.normal;
          support[v] = plane.support;
        }
      },
      grain);
  return support;
}

/** Takes out working points with hardly any others around them, and what they stand for. */
void
dropUnsupported(WorkingCloud& cloud, const std::vector<float>& support)
{
  constexpr float little = 0.05F; // of the median; the density may well vary by ten
  const float least = little * median(support);
  std::vector<Index> new_number(cloud.points.size(), no_index);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < cloud.points.size(); ++v) {
    if (support[v] >= least) {
      cloud.points[kept] = cloud.points[v];
      cloud.original[kept] = cloud.original[v];
      new_number[v] = static_cast<Index>(kept++);
    }
  }
  cloud.points.resize(kept);
  cloud.original.resize(kept);
  for (Index& representative : cloud.representatives) {
    if (representative != no_index) {
      representative = new_number[representative];
      cloud.outliers += representative == no_index ? 1U : 0U;
    }
  }
}

} // namespace

WorkingCloud
makeWorkingCloud(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t most, unsigned threads)
{
  WorkingCloud cloud;
  const std::vector<float> mean_distance = neighbourDistances(points, lists);
  const std::vector<char> outlier = findOutliers(lists, mean_distance);
  std::vector<Vector3> inliers;
  std::vector<Index> number;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (outlier[v] == 0) {
      inliers.push_back(points[v]);
      number.push_back(static_cast<Index>(v));
    }
  }
  cloud.outliers = points.size() - inliers.size();
  cloud.smoothing_radius = smoothingRadius(inliers, median(mean_distance));

  constexpr float spacings_per_radius = 5.0F;
  float spacing = cloud.smoothing_radius / spacings_per_radius;
  std::vector<Index> kept;
  if (spacing > 0.0F) {
    kept = thinOut(inliers, spacing);
  }
  else {
    kept.resize(inliers.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      kept[i] = static_cast<Index>(i);
    }
  }
  while (kept.size() > most) {
    // On a surface the number of points falls with the square of the spacing.
    const float finer = std::max(spacing, median(mean_distance));
    spacing = finer * std::max(1.1F, std::sqrt(static_cast<float>(kept.size()) / static_cast<float>(most)));
    kept = thinOut(inliers, spacing);
  }
  std::vector<Index> nearest(inliers.size());
  if (spacing > 0.0F) {
    nearest = nearestKept(inliers, kept, spacing, threads);
  }
  else {
    nearest = kept;
  }
  cloud.representatives.assign(points.size(), no_index);
  for (std::size_t i = 0; i < inliers.size(); ++i) {
    cloud.representatives[number[i]] = nearest[i];
  }
  for (const Index i : kept) {
    cloud.points.push_back(inliers[i]);
    cloud.original.push_back(number[i]);
  }
  if (cloud.smoothing_radius > 0.0F) {
    dropUnsupported(cloud, smooth(cloud.points, inliers, cloud.smoothing_radius, threads));
  }
  return cloud;
}

} // namespace symmetry
} // namespace pcl
