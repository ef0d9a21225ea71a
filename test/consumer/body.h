/** \file
 * \brief A small closed surface made in code: an egg with two arms, two legs, a head and a nose, left and right alike.
 */
#pragma once

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace consumer {

/** \brief A bump of the egg: where it points, how far it stands out, how narrow it is. */
struct Bump {
  pcl::symmetry::Vector3 direction;
  float height;
  float narrowness;
};

inline const std::vector<Bump>&
bumps()
{
  static const std::vector<Bump> arms_legs_head_nose{
      {{0.94F, 0.0F, 0.34F}, 1.6F, 40.0F},   {{-0.94F, 0.0F, 0.34F}, 1.6F, 40.0F}, {{0.42F, 0.0F, -0.91F}, 1.9F, 40.0F},
      {{-0.42F, 0.0F, -0.91F}, 1.9F, 40.0F}, {{0.0F, 0.0F, 1.0F}, 0.7F, 12.0F},    {{0.0F, 0.87F, 0.5F}, 0.3F, 40.0F},
  };
  return arms_legs_head_nose;
}

inline float
radius(const pcl::symmetry::Vector3& direction)
{
  float sum = 1.0F;
  for (const Bump& bump : bumps()) {
    float cosine = 0.0F;
    for (std::size_t k = 0; k < 3; ++k)
      cosine += direction[k] * bump.direction[k];
    sum += bump.height * std::exp(bump.narrowness * (cosine - 1.0F));
  }
  return sum;
}

/** \brief Divides every triangle of a unit sphere into four. */
inline void
refineSphere(pcl::symmetry::Surface& sphere)
{
  std::map<std::pair<pcl::symmetry::Index, pcl::symmetry::Index>, pcl::symmetry::Index> middles;
  const auto middle = [&](pcl::symmetry::Index a, pcl::symmetry::Index b) {
    const auto [entry, added] =
        middles.try_emplace(std::minmax(a, b), static_cast<pcl::symmetry::Index>(sphere.points.size()));
    if (added) {
      const auto& p = sphere.points[static_cast<std::size_t>(a)];
      const auto& q = sphere.points[static_cast<std::size_t>(b)];
      const float length = std::hypot(p[0] + q[0], p[1] + q[1], p[2] + q[2]);
      sphere.points.push_back({(p[0] + q[0]) / length, (p[1] + q[1]) / length, (p[2] + q[2]) / length});
    }
    return entry->second;
  };
  std::vector<pcl::symmetry::Triangle> triangles;
  for (const auto& [a, b, c] : sphere.triangles) {
    const auto ab = middle(a, b);
    const auto bc = middle(b, c);
    const auto ca = middle(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  sphere.triangles = std::move(triangles);
}

/** \brief A sphere from an octahedron, each of its points moved out to the egg and its bumps. */
inline pcl::symmetry::Surface
makeBody()
{
  pcl::symmetry::Surface body;
  body.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  body.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < 5; ++level)
    refineSphere(body);
  for (auto& point : body.points) {
    const float r = radius(point);
    point = {r * point[0], 0.6F * r * point[1], r * point[2]};
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
