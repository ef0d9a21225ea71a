#include "cloud/cloud_normals.h"

#include "base/parallel.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace pcl {
namespace symmetry {
namespace {

constexpr FanSettings settings{};

Vector3
planeNormal(const std::vector<Vector3>& points, const NeighbourLists& lists, std::size_t v)
{
  float farthest = 0.0F;
  for (const Index u : lists.of(v)) {
    farthest = std::max(farthest, distance(points[u], points[v]));
  }
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  float total = 0.0F;
  const float inverse = farthest > 0.0F ? 1.0F / farthest : 0.0F;
  const auto add = [&](const Vector3& p) {
    const Vector3 offset = inverse * (p - points[v]);
    const Eigen::Vector3f x(offset[0], offset[1], offset[2]);
    const float weight = std::exp(-settings.falloff * x.squaredNorm());
    mean += weight * x;
    covariance += weight * x * x.transpose();
    total += weight;
  };
  add(points[v]);
  for (const Index u : lists.of(v)) {
    if (static_cast<std::size_t>(u) != v) {
      add(points[u]);
    }
  }
  covariance -= mean * mean.transpose() / total;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3f normal = solver.eigenvectors().col(0);
  return normal.allFinite() ? normalized({normal.x(), normal.y(), normal.z()}) : Vector3{0.0F, 0.0F, 1.0F};
}

/** How little the sign is to be trusted across an edge: 0 for parallel normals at right angles to the edge. */
float
edgeDoubt(const Vector3& n, const Vector3& other, const Vector3& direction)
{
  return 1.0F - std::abs(dot(n, other)) + std::abs(dot(direction, n));
}

struct Front {
  float doubt;
  Index from;
  Index to;

  bool
  operator<(const Front& other) const // the queue's top is the largest
  {
    return doubt != other.doubt ? doubt > other.doubt : (from != other.from ? from > other.from : to > other.to);
  }
};

} // namespace

std::vector<Vector3>
estimateNormals(const std::vector<Vector3>& points, const NeighbourLists& neighbours)
{
  std::vector<Vector3> normals(points.size());
  constexpr std::size_t grain = 512;
  parallelFor(
      points.size(), [&](std::size_t v) { normals[v] = planeNormal(points, neighbours, v); }, grain);
  return normals;
}

void
orientNormals(const std::vector<Vector3>& points,
              const SurfaceGraph& graph,
              const std::vector<char>& is_oriented,
              std::vector<Vector3>& normals)
{
  Vector3 centroid{0.0F, 0.0F, 0.0F};
  for (const Vector3& p : points) {
    centroid = centroid + (1.0F / static_cast<float>(points.size())) * p;
  }
  std::vector<Index> starts(points.size());
  std::iota(starts.begin(), starts.end(), 0);
  std::stable_sort(starts.begin(), starts.end(),
                   [&](Index a, Index b) { return distance(points[a], centroid) > distance(points[b], centroid); });

  std::vector<char> done(points.size(), 0);
  std::priority_queue<Front> front;
  const auto settle = [&](Index v) {
    done[v] = 1;
    for (const Index w : graph.neighboursOf(v)) {
      if (done[w] == 0) {
        front.push({edgeDoubt(normals[v], normals[w], normalized(points[w] - points[v])), v, w});
      }
    }
  };
  const auto spread = [&] {
    while (!front.empty()) {
      const Front edge = front.top();
      front.pop();
      if (done[edge.to] != 0) {
        continue;
      }
      const Vector3 direction = normalized(points[edge.to] - points[edge.from]);
      const Vector3& n = normals[edge.from];
      const Vector3 mirrored = n - 2.0F * dot(n, direction) * direction;
      if (dot(mirrored, normals[edge.to]) < 0.0F) {
        normals[edge.to] = -1.0F * normals[edge.to];
      }
      settle(edge.to);
    }
  };
  for (std::size_t v = 0; v < is_oriented.size(); ++v) {
    if (is_oriented[v] != 0) {
      settle(static_cast<Index>(v));
    }
  }
  spread();
  for (const Index start : starts) {
    if (done[start] != 0) {
      continue;
    }
    if (dot(normals[start], points[start] - centroid) < 0.0F) {
      normals[start] = -1.0F * normals[start];
    }
    settle(start);
    spread();
  }
}

} // namespace symmetry
} // namespace pcl
