#include "symmetry/confidence/map_asymmetry.h"

#include "base/statistics.h"
#include "symmetry/search/map_regrowth.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr float tiny = 1e-3F; // relative change of distances: keeps the ratio of two finite

/** Weights that fall off with the distance from every landmark: column i those around landmark i, exp (-(d /
 * radius)^2). \param[in] radius share of the diameter */
Eigen::MatrixXf
windows(const LandmarkSurface& landmarks, float radius)
{
  const float scale = 1.0F / (radius * landmarks.diameter);
  return (-(landmarks.distances.array() * scale).square()).unaryExpr([](float x) { return std::exp(x); }).matrix();
}

/** Weights as of windows (), 0 for the landmarks that cannot be compared. */
Eigen::MatrixXf
comparableWindows(const LandmarkSurface& landmarks, float radius, const std::vector<char>& comparable)
{
  Eigen::MatrixXf window = windows(landmarks, radius);
  for (std::size_t j = 0; j < comparable.size(); ++j) {
    if (comparable[j] == 0) {
      window.row(static_cast<Eigen::Index>(j)).setZero();
    }
  }
  return window;
}

/** Every column replaced by the mean of it and of the columns of the nearest landmarks, those of them that can be
 * compared.
 */
Eigen::MatrixXf
averagedColumns(const Eigen::MatrixXf& matrix, const LandmarkSurface& landmarks, const std::vector<char>& comparable)
{
  constexpr std::size_t next = 6; // landmarks around one in a triangulation, the mean
  Eigen::MatrixXf mean = matrix;
  for (std::size_t i = 0; i < landmarks.nearest.size(); ++i) {
    auto column = mean.col(static_cast<Eigen::Index>(i));
    const std::vector<Index>& nearest = landmarks.nearest[i];
    int count = 1;
    for (std::size_t k = 0; k < std::min(next, nearest.size()); ++k) {
      const Index j = nearest[k];
      if (comparable[j] != 0) {
        column += matrix.col(j);
        ++count;
      }
    }
    column /= static_cast<float>(count);
  }
  return mean;
}

/** Around every landmark that can be compared, by how much the map changes distances to it, as a share of those
 * distances. The changes are averaged over the landmarks next to both ends first: a map can only send landmarks to
 * landmarks, which are some way apart. */
std::vector<float>
stretchAround(const LandmarkSurface& landmarks, const SampleMap& map)
{
  constexpr float radius = 0.2F; // share of the diameter, half of a limb; by hand
  const std::vector<char> comparable = comparableLandmarks(landmarks, map);
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXf change(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto from_image = landmarks.distances.col(map[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < count; ++i) {
      change(i, j) = landmarks.distances(i, j) - from_image(map[static_cast<std::size_t>(i)]);
    }
  }
  change =
      averagedColumns(averagedColumns(change, landmarks, comparable).transpose(), landmarks, comparable).cwiseAbs();
  const Eigen::MatrixXf window = comparableWindows(landmarks, radius, comparable);
  std::vector<float> stretch;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (comparable[static_cast<std::size_t>(i)] == 0) {
      continue;
    }
    stretch.push_back(window.col(i).dot(change.col(i)) / window.col(i).dot(landmarks.distances.col(i)));
  }
  return stretch;
}

/** By how much the average distance from every landmark that can be compared differs at its image, share of the
 * diameter. */
std::vector<float>
averageDistanceChanges(const LandmarkSurface& landmarks, const SampleMap& map)
{
  const std::vector<char> comparable = comparableLandmarks(landmarks, map);
  std::vector<float> changes;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (comparable[i] != 0) {
      changes.push_back(std::abs(landmarks.average_distance[i] - landmarks.average_distance[map[i]]) /
                        landmarks.diameter);
    }
  }
  return changes;
}

/** The same as stretchAround () of the curvature, in units of its variance. */
std::vector<float>
curvatureChangeAround(const LandmarkSurface& landmarks, const Eigen::MatrixXf& curvature, const SampleMap& map)
{
  constexpr float radius = 0.12F; // share of the diameter, about a hand and its wrist; by hand
  const std::vector<char> comparable = comparableLandmarks(landmarks, map);
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  const float variance = curvature.topRows(count).squaredNorm() / static_cast<float>(count);
  Eigen::VectorXf change(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    change(i) = (curvature.row(i) - curvature.row(map[static_cast<std::size_t>(i)])).squaredNorm();
  }
  const Eigen::MatrixXf window = comparableWindows(landmarks, radius, comparable);
  std::vector<float> around;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (comparable[static_cast<std::size_t>(i)] == 0) {
      continue;
    }
    around.push_back(variance > 0.0F ? window.col(i).dot(change) / (window.col(i).sum() * variance) : 0.0F);
  }
  return around;
}

float
meanReturnError(const LandmarkSurface& landmarks, const SampleMap& map)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    sum += landmarks.distances(static_cast<Eigen::Index>(i), map[static_cast<std::size_t>(map[i])]);
  }
  return static_cast<float>(sum / static_cast<double>(landmarks.size())) / landmarks.diameter;
}

} // namespace

AsymmetryMeasures
findAsymmetry(const LandmarkSurface& landmarks, const Eigen::MatrixXf& curvature, const SampleMap& map)
{
  constexpr int rounds = 3;
  constexpr double worst_places = 0.97;
  AsymmetryMeasures measures;
  const std::vector<float> torn = stretchAtLandmarks(landmarks, map);
  measures.concentration = (quantile(torn, 0.99) + tiny) / (quantile(torn, 0.5) + tiny);
  const SampleMap relaxed = refittedMap(landmarks, relaxedMap(landmarks, map), rounds);
  measures.stretch = quantile(stretchAround(landmarks, relaxed), worst_places);
  measures.average_distance = quantile(averageDistanceChanges(landmarks, map), worst_places);
  measures.involution = meanReturnError(landmarks, relaxed);
  measures.curvature = quantile(curvatureChangeAround(landmarks, curvature, map), 0.5);
  return measures;
}

} // namespace symmetry
} // namespace pcl
