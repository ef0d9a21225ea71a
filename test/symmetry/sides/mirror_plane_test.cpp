#include "base/vector_math.h"
#include "support/shapes.h"
#include "symmetry/sides/mirror_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr double offset = 1.5;
const Vector3 normal = normalized({1.0F, -2.0F, 0.5F});

/** Random points and their mirror images in a plane, one after another. */
std::vector<Vector3>
mirroredPoints()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-1.0F, 4.0F);
  std::vector<Vector3> points;
  for (int i = 0; i < 100; ++i) {
    const Vector3 p{place(random), place(random), place(random)};
    const float height = dot(normal, p) - static_cast<float>(offset);
    points.push_back(height > 0.0F ? p : p - 2.0F * height * normal);
    points.push_back(height > 0.0F ? p - 2.0F * height * normal : p);
  }
  return points;
}

std::vector<Index>
neighboursAsPartners(std::size_t size)
{
  std::vector<Index> partners;
  for (std::size_t v = 0; v < size; ++v) {
    partners.push_back(static_cast<Index>(v ^ 1U));
  }
  return partners;
}

std::vector<Side>
alternatingSides(std::size_t size, Side first, Side second)
{
  std::vector<Side> sides;
  for (std::size_t v = 0; v < size; ++v) {
    sides.push_back(v % 2 == 0 ? first : second);
  }
  return sides;
}

TEST(MirrorPlane, IsFoundExactlyAndPointsToTheSourceSide)
{
  const std::vector<Vector3> points = mirroredPoints();
  const std::vector<Index> partners = neighboursAsPartners(points.size());
  for (const double sign : {1.0, -1.0}) {
    const Side first = sign > 0.0 ? Side::Source : Side::Target;
    const Side second = sign > 0.0 ? Side::Target : Side::Source;
    const MirrorPlane plane = fitMirrorPlane(points, partners, alternatingSides(points.size(), first, second));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(plane.normal[k], sign * normal[k], 1e-6);
    }
    EXPECT_NEAR(plane.offset, sign * offset, 1e-6);
    EXPECT_LT(plane.rms, 1e-6);
  }
}

TEST(MirrorPlane, HasTheMotionThatBringsItToX)
{
  const std::vector<Vector3> points = mirroredPoints();
  const MirrorPlane plane = movedPlane(fitMirrorPlane(points, neighboursAsPartners(points.size()),
                                                      alternatingSides(points.size(), Side::Source, Side::Target)),
                                       10.0, {5.0, 6.0, 7.0});
  std::vector<std::array<double, 3>> moved;
  for (const Vector3& p : points) {
    const double place[4] = {10.0 * p[0] + 5.0, 10.0 * p[1] + 6.0, 10.0 * p[2] + 7.0, 1.0};
    std::array<double, 3> to{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        to[i] += plane.to_x[i][k] * place[k];
      }
    }
    moved.push_back(to);
  }
  for (std::size_t v = 0; v < points.size(); v += 2) {
    EXPECT_GT(moved[v][0], 0.0);
    EXPECT_NEAR(moved[v][0], -moved[v + 1][0], 1e-4);
    EXPECT_NEAR(moved[v][1], moved[v + 1][1], 1e-4);
    EXPECT_NEAR(moved[v][2], moved[v + 1][2], 1e-4);
    const auto length = [&](std::size_t i) {
      return std::hypot(moved[v][0] - moved[i][0], moved[v][1] - moved[i][1], moved[v][2] - moved[i][2]);
    };
    EXPECT_NEAR(length(0), 10.0 * distance(points[v], points[0]), 1e-4) << "not rigid";
  }
}

TEST(MirrorPlane, MeasuresHowFarPartnersAreFromMirroredPoints)
{
  std::vector<Vector3> points = mirroredPoints();
  for (std::size_t v = 0; v < points.size(); v += 2) { // off along the plane, to and fro: no plane can help
    points[v] = points[v] + (v % 4 == 0 ? 0.1F : -0.1F) * normalized(cross(normal, {0.0F, 0.0F, 1.0F}));
  }
  const MirrorPlane plane = fitMirrorPlane(points, neighboursAsPartners(points.size()),
                                           alternatingSides(points.size(), Side::Source, Side::Target));
  EXPECT_NEAR(plane.rms, 0.1, 0.005);
}

TEST(MirrorPlane, IsNoneWithoutPartners)
{
  const MirrorPlane plane = fitMirrorPlane({{0, 0, 0}, {1, 0, 0}}, {no_index, no_index}, {Side::None, Side::None});
  EXPECT_EQ(plane.normal, (std::array<double, 3>{}));
  EXPECT_EQ(movedPlane(plane, 2.0, {1.0, 1.0, 1.0}).offset, 0.0);
}

} // namespace
