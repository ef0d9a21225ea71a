#include "geodesic/surface_metric.h"

#include "base/parallel.h"
#include "base/vector_math.h"
#include "geodesic/farthest_point_sampling.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

DistanceFields
GeodesicMetric::fields(const std::vector<Index>& sources) const
{
  const std::lock_guard<std::mutex> lock(solver_mutex_);
  return solver_.fields(sources);
}

std::vector<Index>
GeodesicMetric::farthestPoints(Index start, std::size_t count) const
{
  return farthestPointSampling(graph_, start, count).vertices;
}

std::vector<Index>
GeodesicMetric::midpoints(const std::vector<Index>& sources,
                          const DistanceFields& fields,
                          const std::vector<Index>& targets) const
{
  std::vector<Index> middles(sources.size(), no_index);
  parallelFor(sources.size(), [&](std::size_t i) {
    middles[i] = pathMidpoint(graph_, shortestPath(graph_, fields.row(i), targets[i]));
  });
  return middles;
}

DistanceFields
EuclideanMetric::fields(const std::vector<Index>& sources) const
{
  DistanceFields fields;
  fields.columns = points_.size();
  fields.values.resize(sources.size() * points_.size());
  parallelFor(sources.size(), [&](std::size_t i) {
    float* field = fields.values.data() + i * fields.columns;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      field[v] = distance(points_[sources[i]], points_[v]);
    }
  });
  return fields;
}

std::vector<Index>
EuclideanMetric::farthestPoints(Index start, std::size_t count) const
{
  std::vector<Index> samples;
  std::vector<float> nearest(points_.size(), unreachable);
  Index next = start;
  while (samples.size() < count && nearest[next] > 0.0F) {
    samples.push_back(next);
    const Vector3& sample = points_[next];
    for (std::size_t v = 0; v < points_.size(); ++v) {
      nearest[v] = std::min(nearest[v], distance(sample, points_[v]));
    }
    next = static_cast<Index>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return samples;
}

Index
EuclideanMetric::nearestVertex(const Vector3& position) const
{
  const auto nearer = [&position](const Vector3& a, const Vector3& b) {
    return distance(a, position) < distance(b, position);
  };
  return static_cast<Index>(std::min_element(points_.begin(), points_.end(), nearer) - points_.begin());
}

std::vector<Index>
EuclideanMetric::midpoints(const std::vector<Index>& sources,
                           const DistanceFields& /*fields*/,
                           const std::vector<Index>& targets) const
{
  std::vector<Index> middles(sources.size(), no_index);
  parallelFor(sources.size(),
              [&](std::size_t i) { middles[i] = nearestVertex(0.5F * (points_[sources[i]] + points_[targets[i]])); });
  return middles;
}

} // namespace symmetry
} // namespace pcl
