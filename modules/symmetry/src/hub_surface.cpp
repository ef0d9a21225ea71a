#include "symmetry/hub_surface.h"

#include "geodesic/shortest_paths.h"
#include "geodesic/vector_math.h"

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

/** Nearest hub of every sample; ties go to the lower hub. */
std::vector<Index>
nearestHubs(const DistanceFields& fields)
{
  std::vector<Index> nearest(fields.columns, 0);
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
extremitiesOf(const HubSurface& hubs, float separation, std::size_t most)
{
  std::vector<Index> order(hubs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return hubs.centrality[a] > hubs.centrality[b]; });
  std::vector<Index> extremities;
  for (const Index candidate : order) {
    bool is_maximum = true;
    for (std::size_t other = 0; is_maximum && other < hubs.size(); ++other) {
      is_maximum = hubs.distances(candidate, static_cast<Eigen::Index>(other)) >= separation * hubs.diameter ||
                   hubs.centrality[other] <= hubs.centrality[candidate];
    }
    if (is_maximum && extremities.size() < most) {
      extremities.push_back(candidate);
    }
  }
  return extremities;
}

std::vector<char>
comparableHubs(const HubSurface& hubs, const std::vector<Index>& map)
{
  constexpr std::size_t fewest = 5; // a fifth
  std::vector<char> comparable(map.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    comparable[i] = hubs.at_hole[i] == 0 && hubs.at_hole[map[i]] == 0 ? 1 : 0;
    count += static_cast<std::size_t>(comparable[i]);
  }
  if (fewest * count < map.size()) {
    std::fill(comparable.begin(), comparable.end(), 1);
  }
  return comparable;
}

HubSurface
makeHubSurface(const CoarseSurface& surface, std::size_t hubs, Metric metric, unsigned threads)
{
  HubSurface result;
  const std::size_t count = std::min(hubs, surface.size());
  std::vector<Index> sources(count);
  std::iota(sources.begin(), sources.end(), 0);
  const DistanceFields fields = distanceFields(surface.graph, sources, threads);

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
  result.diameter = result.distances.maxCoeff();
  result.points.assign(surface.points.begin(), surface.points.begin() + n);
  result.normals.assign(surface.normals.begin(), surface.normals.begin() + n);
  result.at_hole.assign(surface.at_hole.begin(), surface.at_hole.begin() + n);
  result.nearest_hub = nearestHubs(fields);
  result.triangles = dualTriangles(surface.triangles, result.nearest_hub);
  const Eigen::VectorXf mean = result.distances.rowwise().mean();
  result.centrality.assign(mean.data(), mean.data() + n);
  constexpr float separation = 1.0F / 15.0F;
  constexpr std::size_t most = 10;
  result.extremities = extremitiesOf(result, separation, most);
  return result;
}

} // namespace symmetry
} // namespace pcl
