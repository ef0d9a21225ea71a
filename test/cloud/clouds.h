/** \file
 * \brief Clouds of known shape for the tests, and their neighbours.
 */
#pragma once

#include "base/vector_math.h"
#include "geodesic/neighbour_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Evenly spread over [low, high); the same numbers with any standard library. */
inline float
evenly(std::mt19937& random, float low, float high)
{
  return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
}

/** \brief Close to normally distributed, with deviation 1: the sum of twelve evenly spread numbers. */
inline float
bellShaped(std::mt19937& random)
{
  float sum = 0.0F;
  for (int i = 0; i < 12; ++i) {
    sum += evenly(random, -0.5F, 0.5F);
  }
  return sum;
}

/** \brief n points evenly spread over a sphere, along a spiral of the golden angle. */
inline std::vector<Vector3>
sphereCloud(std::size_t n, float radius, const Vector3& centre = {0.0F, 0.0F, 0.0F})
{
  constexpr double golden_angle = 2.399963229728653;
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(n);
    const double across = std::sqrt(1.0 - z * z);
    const double angle = golden_angle * static_cast<double>(i);
    const Vector3 direction{static_cast<float>(across * std::cos(angle)), static_cast<float>(across * std::sin(angle)),
                            static_cast<float>(z)};
    points.push_back(centre + radius * direction);
  }
  return points;
}

/** \brief Every point moved in a random direction.
 *
 * \param[in] deviation along each axis */
inline std::vector<Vector3>
noisy(std::vector<Vector3> points, float deviation, unsigned seed)
{
  std::mt19937 random(seed);
  for (Vector3& p : points) {
    for (float& x : p) {
      x += deviation * bellShaped(random);
    }
  }
  return points;
}

/** \brief The k nearest others of every point, found by a sweep along x. */
inline NeighbourLists
nearestNeighbours(const std::vector<Vector3>& points, int k)
{
  NeighbourLists lists;
  lists.k = static_cast<std::size_t>(k);
  lists.neighbours.assign(points.size() * lists.k, no_index);
  std::vector<Index> by_x(points.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(), [&](Index a, Index b) { return points[a] < points[b]; });
  std::vector<std::pair<float, Index>> nearest;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Vector3& place = points[by_x[i]];
    nearest.clear();
    // False once a point is too far away along x alone.
    const auto consider = [&](Index other) {
      const Vector3 offset = points[other] - place;
      const bool full = nearest.size() == lists.k;
      if (full && offset[0] * offset[0] > nearest.back().first) {
        return false;
      }
      const std::pair<float, Index> entry{dot(offset, offset), other};
      if (!full || entry < nearest.back()) {
        nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), entry), entry);
        nearest.resize(std::min(nearest.size(), lists.k));
      }
      return true;
    };
    bool forward = true;
    bool backward = true;
    for (std::size_t step = 1; forward || backward; ++step) {
      forward = forward && i + step < by_x.size() && consider(by_x[i + step]);
      backward = backward && step <= i && consider(by_x[i - step]);
    }
    for (std::size_t j = 0; j < nearest.size(); ++j) {
      lists.neighbours[static_cast<std::size_t>(by_x[i]) * lists.k + j] = nearest[j].second;
    }
  }
  return lists;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
