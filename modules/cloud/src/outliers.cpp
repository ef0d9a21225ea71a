#include "cloud/outliers.h"

#include "base/statistics.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr OutlierSettings settings{};

/** Points whose neighbours are, in the lower quartile, several times closer to theirs. */
std::vector<char>
findLocalOutliers(const NeighbourLists& lists, const std::vector<float>& mean_distance)
{
  std::vector<char> outlier(mean_distance.size(), 0);
  std::vector<float> around;
  for (std::size_t v = 0; v < mean_distance.size(); ++v) {
    around.clear();
    for (const Index u : lists.of(v)) {
      if (static_cast<std::size_t>(u) != v) {
        around.push_back(mean_distance[u]);
      }
    }
    if (!around.empty()) {
      const float quartile = quantileInPlace(around, 0.25);
      outlier[v] = static_cast<char>(quartile > 0.0F && mean_distance[v] > settings.local_ratio * quartile);
    }
  }
  return outlier;
}

/** Where the neighbours of a point lie, and perhaps itself, seen from it. */
struct Neighbourhood {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
};

Neighbourhood
neighbourhood(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t v, float weight_of_itself)
{
  Neighbourhood around;
  float number = weight_of_itself;
  for (const Index u : lists.of(v)) {
    if (static_cast<std::size_t>(u) != v) {
      const Vector3 offset = points[u] - points[v];
      const Eigen::Vector3f x(offset[0], offset[1], offset[2]);
      around.mean += x;
      around.covariance += x * x.transpose();
      number += 1.0F;
    }
  }
  if (number > 0.0F) {
    around.mean /= number;
    around.covariance = around.covariance / number - around.mean * around.mean.transpose();
  }
  return around;
}

/** Standard deviation of a point, which counts twice, and its neighbours across their plane, over that in all
 * directions: 0 of a plane, 0.58 of a ball. */
float
flatness(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t v)
{
  const Eigen::Matrix3f covariance = neighbourhood(points, lists, v, 2.0F).covariance;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  const float all = covariance.trace();
  return all > 0.0F ? std::sqrt(std::max(0.0F, solver.eigenvalues()(0)) / all) : 0.0F;
}

/** Whether a point is off the plane through its neighbours by more than these are.
 * \param[in] mean_distance from them */
bool
isOffPlane(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t v, float mean_distance)
{
  const Neighbourhood around = neighbourhood(points, lists, v, 0.0F);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(around.covariance);
  const float offset = std::abs(solver.eigenvectors().col(0).dot(around.mean));
  return offset > settings.plane_deviations * std::sqrt(std::max(0.0F, solver.eigenvalues()(0))) &&
         offset > settings.plane_distances * mean_distance;
}

/** Marks points beside the surface: hardly any of their neighbours has them among its own, since the surface has nearer
 * ones for it, and they are off the plane of their neighbours. */
void
markBesideSurface(const std::vector<Vector3>& points,
                  const NeighbourLists& lists,
                  const std::vector<float>& distances,
                  std::vector<char>& outlier)
{
  std::vector<int> times_a_neighbour(points.size(), 0);
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (const Index u : lists.of(v)) {
      times_a_neighbour[u] += static_cast<std::size_t>(u) != v ? 1 : 0;
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (outlier[v] == 0 && times_a_neighbour[v] <= settings.maximum_times &&
        isOffPlane(points, lists, v, distances[v])) {
      outlier[v] = 1;
    }
  }
}

/** Whether noise fills space as outliers do: then these are told when the noise is smoothed. */
bool
isThick(const std::vector<Vector3>& points, const NeighbourLists& lists)
{
  const std::size_t stride = std::max<std::size_t>(1, points.size() / settings.probes);
  std::vector<float> probed;
  for (std::size_t v = 0; v < points.size(); v += stride) {
    probed.push_back(flatness(points, lists, v));
  }
  return median(probed) > settings.noise_flatness;
}

/** Marks also what has hardly any neighbours that are not marked. */
void
spread(const NeighbourLists& lists, std::vector<char>& outlier)
{
  for (int round = 0; round < settings.spreading_rounds; ++round) {
    const std::vector<char> before = outlier;
    for (std::size_t v = 0; v < outlier.size(); ++v) {
      std::size_t marked = 0;
      for (const Index u : lists.of(v)) {
        marked += static_cast<std::size_t>(before[u]);
      }
      if (2 * marked > lists.of(v).size()) {
        outlier[v] = 1;
      }
    }
  }
}

} // namespace

std::vector<float>
neighbourDistances(const std::vector<Vector3>& points, const NeighbourLists& lists)
{
  std::vector<float> mean(points.size(), 0.0F);
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (const Index u : lists.of(v)) {
      mean[v] += distance(points[v], points[u]);
    }
    mean[v] /= static_cast<float>(std::max<std::size_t>(lists.of(v).size(), 1));
  }
  return mean;
}

std::vector<char>
findOutliers(const std::vector<Vector3>& points, const NeighbourLists& lists, const std::vector<float>& distances)
{
  std::vector<char> outlier = findLocalOutliers(lists, distances);
  if (isThick(points, lists)) {
    return outlier;
  }
  markBesideSurface(points, lists, distances, outlier);
  const float far = settings.sparse_distance * median(distances);
  bool found = false;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (outlier[v] == 0 && distances[v] > far && flatness(points, lists, v) > settings.filling_flatness) {
      outlier[v] = 1;
      found = true;
    }
  }
  if (found) {
    spread(lists, outlier);
  }
  return outlier;
}

} // namespace symmetry
} // namespace pcl
