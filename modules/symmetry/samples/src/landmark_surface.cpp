#include "symmetry/samples/landmark_surface.h"

#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/samples/sample_settings.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr LandmarkSettings settings{};

/** Nearest landmark of every sample; ties go to the lower landmark. */
std::vector<Index>
nearestOfSamples(const DistanceFields& fields)
{
  std::vector<Index> nearest(fields.columns);
  for (std::size_t i = 1; i < fields.rows(); ++i) {
    for (std::size_t v = 0; v < fields.columns; ++v) {
      if (fields.row(i)[v] < fields.row(static_cast<std::size_t>(nearest[v]))[v]) {
        nearest[v] = static_cast<Index>(i);
      }
    }
  }
  return nearest;
}

} // namespace

std::vector<Index>
extremitiesOf(const LandmarkSurface& landmarks, float separation, std::size_t maximum_count)
{
  std::vector<Index> order(landmarks.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return landmarks.average_distance[a] > landmarks.average_distance[b]; });
  std::vector<Index> extremities;
  for (const Index candidate : order) {
    bool is_maximum = true;
    for (std::size_t other = 0; is_maximum && other < landmarks.size(); ++other) {
      is_maximum =
          landmarks.distances(candidate, static_cast<Eigen::Index>(other)) >= separation * landmarks.diameter ||
          landmarks.average_distance[other] <= landmarks.average_distance[candidate];
    }
    if (is_maximum && extremities.size() < maximum_count) {
      extremities.push_back(candidate);
    }
  }
  return extremities;
}

std::vector<char>
comparableLandmarks(const LandmarkSurface& landmarks, const std::vector<Index>& map)
{
  std::vector<char> comparable(map.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    comparable[i] = landmarks.at_hole[i] == 0 && landmarks.at_hole[map[i]] == 0 ? 1 : 0;
    count += static_cast<std::size_t>(comparable[i]);
  }
  if (settings.comparable_part * count < map.size()) {
    std::fill(comparable.begin(), comparable.end(), 1);
  }
  return comparable;
}

std::vector<std::vector<Index>>
nearestLandmarks(const Eigen::MatrixXf& distances, std::size_t count)
{
  const auto landmarks = static_cast<std::size_t>(distances.cols());
  std::vector<std::vector<Index>> nearest(landmarks);
  std::vector<Index> order(landmarks);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = 0; i < landmarks; ++i) {
    const auto from = distances.col(static_cast<Eigen::Index>(i));
    const auto comes_before = [&](Index a, Index b) {
      return from(a) < from(b) || (from(a) == from(b) && a < b);
    };
    std::vector<Index> others = order;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(count, others.size()));
    std::partial_sort(others.begin(), end, others.end(), comes_before);
    nearest[i].assign(others.begin(), end);
  }
  return nearest;
}

LandmarkSurface
makeLandmarkSurface(const CoarseSurface& surface, std::size_t landmarks, Metric metric)
{
  LandmarkSurface result;
  const std::size_t count = std::min(landmarks, surface.size());
  std::vector<Index> sources(count);
  std::iota(sources.begin(), sources.end(), 0);
  const DistanceFields fields = distanceFields(surface.graph, sources);

  const auto n = static_cast<Eigen::Index>(count);
  result.distances.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (metric == Metric::Euclidean) {
      for (Eigen::Index j = 0; j < n; ++j) {
        result.distances(j, i) =
            distance(surface.points[static_cast<std::size_t>(i)], surface.points[static_cast<std::size_t>(j)]);
      }
      continue;
    }
    result.distances.col(i) = Eigen::Map<const Eigen::VectorXf>(fields.row(static_cast<std::size_t>(i)), n);
  }
  result.distances = (0.5F * (result.distances + result.distances.transpose())).eval();
  result.to_samples =
      Eigen::Map<const Eigen::MatrixXf>(fields.values.data(), static_cast<Eigen::Index>(fields.columns), n);
  result.diameter = result.distances.maxCoeff();
  result.points.assign(surface.points.begin(), surface.points.begin() + n);
  result.normals.assign(surface.normals.begin(), surface.normals.begin() + n);
  result.at_hole.assign(surface.at_hole.begin(), surface.at_hole.begin() + n);
  result.nearest_landmark = nearestOfSamples(fields);
  result.nearest = nearestLandmarks(result.distances);
  result.triangles = dualTriangles(surface.triangles, result.nearest_landmark);
  const Eigen::VectorXf mean = result.distances.rowwise().mean();
  result.average_distance.assign(mean.data(), mean.data() + n);
  result.extremities = extremitiesOf(result, settings.separation, settings.maximum_extremities);
  return result;
}

} // namespace symmetry
} // namespace pcl
