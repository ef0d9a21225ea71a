/** \file
 * \brief What the tests of resampled clouds share.
 */
#pragma once

#include "cloud/clouds.h"
#include "cloud/resampled_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace test {

constexpr float sphere_radius = 0.4F;
constexpr std::size_t any_number = 1000000;

inline ResampledCloud
resampledCloud(const std::vector<Vector3>& points, std::size_t most = any_number)
{
  return resampleCloud(points, nearestNeighbours(points, 10), most);
}

inline float
meanErrorOnSphere(const std::vector<Vector3>& points)
{
  double sum = 0.0;
  for (const Vector3& p : points) {
    sum += std::abs(double{norm(p)} - double{sphere_radius});
  }
  return static_cast<float>(sum / static_cast<double>(points.size()));
}

inline std::size_t
unrepresented(const ResampledCloud& cloud)
{
  return static_cast<std::size_t>(std::count(cloud.representatives.begin(), cloud.representatives.end(), no_index));
}

/** \brief One half of a sphere sampled ten times as densely as the other. */
inline std::vector<Vector3>
unevenSphere(std::size_t n)
{
  std::vector<Vector3> points;
  for (const Vector3& p : sphereCloud(2 * n, sphere_radius)) {
    if (p[0] > 0.0F) {
      points.push_back(p);
    }
  }
  for (const Vector3& p : sphereCloud(n / 5, sphere_radius)) {
    if (p[0] <= 0.0F) {
      points.push_back(p);
    }
  }
  return points;
}

/** \brief What holds for any resampled cloud. */
inline void
expectConsistent(const ResampledCloud& cloud, std::size_t points)
{
  ASSERT_EQ(cloud.representatives.size(), points);
  ASSERT_EQ(cloud.original.size(), cloud.points.size());
  for (const Index representative : cloud.representatives) {
    ASSERT_GE(representative, no_index);
    ASSERT_LT(representative, static_cast<Index>(cloud.points.size()));
  }
  for (std::size_t w = 0; w < cloud.points.size(); ++w) {
    ASSERT_EQ(cloud.representatives[cloud.original[w]], static_cast<Index>(w)); // each stands for itself
  }
}

} // namespace test
} // namespace symmetry
} // namespace pcl
