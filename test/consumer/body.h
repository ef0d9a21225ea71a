/** \file
 * \brief A small closed surface made in code: an egg with two arms, two legs, a head and a nose, left and right alike.
 */
#pragma once

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace consumer {

constexpr int rings = 48;
constexpr int ring_size = 96;

/** \brief A bump of the egg: where it points, how far it stands out, how narrow it is. */
struct Bump {
  std::array<double, 3> direction;
  double height;
  double narrowness;
};

inline const std::vector<Bump>&
bumps()
{
  static const std::vector<Bump> all{{{0.94, 0.0, 0.34}, 1.6, 40.0},                                 // arms
                                     {{-0.94, 0.0, 0.34}, 1.6, 40.0},                                //
                                     {{0.42, 0.0, -0.91}, 1.9, 40.0},                                // legs
                                     {{-0.42, 0.0, -0.91}, 1.9, 40.0}, {{0.0, 0.0, 1.0}, 0.7, 12.0}, // head
                                     {{0.0, 0.87, 0.5}, 0.3, 40.0}};                                 // nose
  return all;
}

inline double
radius(const std::array<double, 3>& direction)
{
  double sum = 1.0;
  for (const Bump& bump : bumps()) {
    double cosine = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      cosine += direction[k] * bump.direction[k];
    sum += bump.height * std::exp(bump.narrowness * (cosine - 1.0));
  }
  return sum;
}

/** \brief Number of the point at \a column of \a ring; columns count on around the ring. */
inline pcl::symmetry::Index
pointIndex(int ring, int column)
{
  return 1 + ring * ring_size + (column + ring_size) % ring_size;
}

inline pcl::symmetry::Vector3
point(double polar, double azimuth)
{
  const std::array<double, 3> direction{std::sin(polar) * std::sin(azimuth), std::sin(polar) * std::cos(azimuth),
                                        std::cos(polar)};
  const double r = radius(direction);
  return {static_cast<float>(r * direction[0]), static_cast<float>(0.6 * r * direction[1]),
          static_cast<float>(r * direction[2])};
}

/** \brief Pole, rings from top to bottom, pole. */
inline pcl::symmetry::Surface
makeBody()
{
  const double pi = std::acos(-1.0);
  pcl::symmetry::Surface body;
  body.points.push_back(point(0.0, 0.0));
  for (int ring = 0; ring < rings; ++ring)
    for (int column = 0; column < ring_size; ++column)
      body.points.push_back(point(pi * (ring + 1) / (rings + 1), 2.0 * pi * column / ring_size));
  body.points.push_back(point(pi, 0.0));
  const auto last = static_cast<pcl::symmetry::Index>(body.points.size() - 1);
  for (int column = 0; column < ring_size; ++column) {
    body.triangles.push_back({0, pointIndex(0, column + 1), pointIndex(0, column)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      body.triangles.push_back({pointIndex(ring, column), pointIndex(ring, column + 1), pointIndex(ring + 1, column)});
      body.triangles.push_back(
          {pointIndex(ring, column + 1), pointIndex(ring + 1, column + 1), pointIndex(ring + 1, column)});
    }
    body.triangles.push_back({pointIndex(rings - 1, column), pointIndex(rings - 1, column + 1), last});
  }
  return body;
}

/** \brief Share of the points whose partner lies within a tenth of the body's height of their mirror image (x -> -x).
 */
inline double
shareOfRightPartners(const pcl::symmetry::Surface& body, const std::vector<pcl::symmetry::Index>& partners)
{
  const auto [lowest, highest] = std::minmax_element(body.points.begin(), body.points.end(),
                                                     [](const auto& a, const auto& b) { return a[2] < b[2]; });
  const float tolerance = 0.1F * ((*highest)[2] - (*lowest)[2]);
  std::size_t right = 0;
  for (std::size_t i = 0; i < partners.size() && i < body.size(); ++i) {
    if (partners[i] < 0 || static_cast<std::size_t>(partners[i]) >= body.size())
      continue;
    const auto& p = body.points[i];
    const auto& q = body.points[static_cast<std::size_t>(partners[i])];
    if (std::hypot(p[0] + q[0], p[1] - q[1], p[2] - q[2]) <= tolerance)
      ++right;
  }
  return static_cast<double>(right) / static_cast<double>(body.size());
}

} // namespace consumer
