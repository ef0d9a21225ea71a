// Normals and spacings of clouds of known shape.
#include "base/vector_math.h"
#include "picture/cloud_shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl::symmetry;

namespace {

/** Points on a sphere around the origin, evenly spread (Fibonacci lattice). */
std::vector<Vector3>
sphere(int count, double radius)
{
  std::vector<Vector3> points;
  const double golden_angle = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double across = std::sqrt(1.0 - z * z);
    points.push_back({static_cast<float>(radius * across * std::cos(golden_angle * i)),
                      static_cast<float>(radius * across * std::sin(golden_angle * i)),
                      static_cast<float>(radius * z)});
  }
  return points;
}

TEST(CloudShading, NormalsOfASpherePointAlongItsRadii)
{
  const std::vector<Vector3> points = sphere(8000, 2.0);
  const CloudShading shading = estimateCloudShading(points);
  ASSERT_EQ(shading.normals.size(), points.size());
  ASSERT_EQ(shading.spacings.size(), points.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(norm(shading.normals[i]), 1.0F, 1e-4F);
    sum += std::abs(dot(shading.normals[i], normalized(points[i])));
  }
  EXPECT_GT(sum / static_cast<double>(points.size()), 0.99);
}

TEST(CloudShading, SpacingIsThatOfEvenPointsAndGrowsWithTheCloud)
{
  const std::vector<Vector3> points = sphere(8000, 2.0);
  const double even = std::sqrt(4.0 * std::acos(-1.0) * 4.0 / 8000.0); // side of the square that each point has
  const CloudShading shading = estimateCloudShading(points);
  double mean = 0.0;
  for (const float spacing : shading.spacings)
    mean += static_cast<double>(spacing) / static_cast<double>(points.size());
  EXPECT_GT(mean, 0.5 * even);
  EXPECT_LT(mean, 2.0 * even);
  const CloudShading larger = estimateCloudShading(sphere(8000, 8.0));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(larger.spacings[i], 4.0F * shading.spacings[i], 1e-3F);
}

TEST(CloudShading, PointsThatAreNoneGetNothing)
{
  std::vector<Vector3> points = sphere(500, 1.0);
  points.push_back({std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F});
  const CloudShading shading = estimateCloudShading(points);
  EXPECT_EQ(shading.normals.back(), (Vector3{0.0F, 0.0F, 0.0F}));
  EXPECT_EQ(shading.spacings.back(), 0.0F);
  EXPECT_TRUE(estimateCloudShading({}).normals.empty());
  const CloudShading same = estimateCloudShading({{1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F}});
  EXPECT_EQ(same.normals[0], (Vector3{0.0F, 0.0F, 0.0F})) << "one place has no normal";
}

} // namespace
