#include "symmetry/map_asymmetry.h"

#include "geodesic/median.h"
#include "symmetry/map_repair.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr float tiny = 1e-3F;

/** Weights that fall off with the distance from every hub: column i those around hub i, exp (-(d / radius)^2).
 * \param[in] radius share of the diameter */
Eigen::MatrixXf
windows(const HubSurface& hubs, float radius)
{
  const float scale = 1.0F / (radius * hubs.diameter);
  return (-(hubs.distances.array() * scale).square()).unaryExpr([](float x) { return std::exp(x); }).matrix();
}

/** Weights as of windows (), 0 for the hubs that cannot be compared. */
Eigen::MatrixXf
comparableWindows(const HubSurface& hubs, float radius, const std::vector<char>& comparable)
{
  Eigen::MatrixXf window = windows(hubs, radius);
  for (std::size_t j = 0; j < comparable.size(); ++j) {
    if (comparable[j] == 0) {
      window.row(static_cast<Eigen::Index>(j)).setZero();
    }
  }
  return window;
}

/** Every column replaced by the mean of it and of the columns of the nearest hubs, those of them that can be compared.
 */
Eigen::MatrixXf
averagedColumns(const Eigen::MatrixXf& matrix,
                const std::vector<std::vector<Index>>& nearest,
                const std::vector<char>& comparable)
{
  Eigen::MatrixXf mean = matrix;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    auto column = mean.col(static_cast<Eigen::Index>(i));
    int count = 1;
    for (const Index j : nearest[i]) {
      if (comparable[j] != 0) {
        column += matrix.col(j);
        ++count;
      }
    }
    column /= static_cast<float>(count);
  }
  return mean;
}

/** Around every hub that can be compared, by how much the map changes distances to it, as a share of those distances.
 * The changes are averaged over the hubs next to both ends first: a map can only send hubs to hubs, which are some way
 * apart. */
std::vector<float>
stretchAround(const HubSurface& hubs, const SampleMap& map)
{
  constexpr std::size_t next = 6;
  constexpr float radius = 0.2F;
  const std::vector<char> comparable = comparableHubs(hubs, map);
  const auto count = static_cast<Eigen::Index>(hubs.size());
  Eigen::MatrixXf change(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto from_image = hubs.distances.col(map[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < count; ++i) {
      change(i, j) = hubs.distances(i, j) - from_image(map[static_cast<std::size_t>(i)]);
    }
  }
  const std::vector<std::vector<Index>> nearest = nearestHubs(hubs, next);
  change = averagedColumns(averagedColumns(change, nearest, comparable).transpose(), nearest, comparable).cwiseAbs();
  const Eigen::MatrixXf window = comparableWindows(hubs, radius, comparable);
  std::vector<float> stretch;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (comparable[static_cast<std::size_t>(i)] == 0) {
      continue;
    }
    stretch.push_back(window.col(i).dot(change.col(i)) / window.col(i).dot(hubs.distances.col(i)));
  }
  return stretch;
}

/** By how much the average distance from every hub that can be compared differs at its image, share of the diameter. */
std::vector<float>
centralityChanges(const HubSurface& hubs, const SampleMap& map)
{
  const std::vector<char> comparable = comparableHubs(hubs, map);
  std::vector<float> changes;
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    if (comparable[i] != 0) {
      changes.push_back(std::abs(hubs.centrality[i] - hubs.centrality[map[i]]) / hubs.diameter);
    }
  }
  return changes;
}

/** The same as stretchAround () of the curvature, in units of its variance. */
std::vector<float>
curvatureChangeAround(const HubSurface& hubs, const Eigen::MatrixXf& curvature, const SampleMap& map)
{
  constexpr float radius = 0.12F;
  const std::vector<char> comparable = comparableHubs(hubs, map);
  const auto count = static_cast<Eigen::Index>(hubs.size());
  const float variance = curvature.topRows(count).squaredNorm() / static_cast<float>(count);
  Eigen::VectorXf change(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    change(i) = (curvature.row(i) - curvature.row(map[static_cast<std::size_t>(i)])).squaredNorm();
  }
  const Eigen::MatrixXf window = comparableWindows(hubs, radius, comparable);
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
meanReturnError(const HubSurface& hubs, const SampleMap& map)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    sum += hubs.distances(static_cast<Eigen::Index>(i), map[static_cast<std::size_t>(map[i])]);
  }
  return static_cast<float>(sum / static_cast<double>(hubs.size())) / hubs.diameter;
}

} // namespace

AsymmetrySigns
findAsymmetry(const HubSurface& hubs, const Eigen::MatrixXf& curvature, const SampleMap& map)
{
  constexpr int rounds = 3;
  constexpr double most = 0.97;
  AsymmetrySigns signs;
  const std::vector<float> torn = stretchAtHubs(hubs, map);
  signs.concentration = (quantile(torn, 0.99) + tiny) / (quantile(torn, 0.5) + tiny);
  const SampleMap relaxed = settledMap(hubs, relaxedMap(hubs, map), rounds);
  signs.stretch = quantile(stretchAround(hubs, relaxed), most);
  signs.centrality = quantile(centralityChanges(hubs, map), most);
  signs.involution = meanReturnError(hubs, relaxed);
  signs.curvature = quantile(curvatureChangeAround(hubs, curvature, map), 0.5);
  return signs;
}

} // namespace symmetry
} // namespace pcl
