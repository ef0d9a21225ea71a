#include "model/implicit_surface.h"
#include "model/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;

namespace {

using V = Eigen::Vector3d;

V
randomPoint(RandomNumbers& random, double reach)
{
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

std::vector<RoundCone>
randomCones(std::size_t count, std::uint64_t seed)
{
  RandomNumbers random(seed);
  std::vector<RoundCone> cones;
  while (cones.size() < count) {
    const V start = randomPoint(random, 1.0);
    const double start_radius = random.uniform(0.05, 0.15);
    const V end = start + 0.5 * V(random.uniform(0.5, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    cones.emplace_back(start, start_radius, end, random.uniform(0.05, 0.15));
  }
  return cones;
}

/** \brief The definition: the nearest of very many spheres along the axis. */
double
distanceBySampling(const RoundCone& cone, const V& point)
{
  constexpr int samples = 20000;
  double nearest = 1e300;
  for (int i = 0; i <= samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    const V centre = (1 - t) * cone.start() + t * cone.end();
    nearest = std::min(nearest, (point - centre).norm() - (1 - t) * cone.startRadius() - t * cone.endRadius());
  }
  return nearest;
}

double
softMinimum(const std::vector<RoundCone>& cones, double blend, const V& point)
{
  double sum = 0.0;
  V unused;
  for (const RoundCone& cone : cones)
    sum += std::exp(-cone.signedDistance(point, unused) / blend);
  return -blend * std::log(sum);
}

TEST(RoundCone, DistanceIsThatOfTheNearestSphereAlongTheAxis)
{
  RandomNumbers random(3);
  V unused;
  for (const RoundCone& cone : randomCones(20, 5)) {
    const V point = randomPoint(random, 1.5);
    EXPECT_NEAR(cone.signedDistance(point, unused), distanceBySampling(cone, point), 1e-6);
  }
}

TEST(RoundCone, WithEqualEndsIsASphere)
{
  V gradient;
  EXPECT_DOUBLE_EQ(RoundCone(V(1, 0, 0), 0.5, V(1, 0, 0), 0.5).signedDistance(V(1, 3, 0), gradient), 2.5);
  EXPECT_EQ(gradient, V(0, 1, 0));
}

TEST(ImplicitSurface, ValueIsTheSoftMinimumOverAllCones)
{
  const std::vector<RoundCone> cones = randomCones(30, 1);
  const ImplicitSurface surface(cones, 0.02);
  RandomNumbers random(2);
  for (int i = 0; i < 500; ++i) {
    const V point = randomPoint(random, 1.6); // some lie outside the box
    EXPECT_NEAR(surface.value(point), softMinimum(cones, 0.02, point), 30 * 0.02 * std::exp(-12.0));
  }
}

TEST(ImplicitSurface, GradientIsThatOfTheValue)
{
  const ImplicitSurface surface(randomCones(30, 1), 0.02);
  RandomNumbers random(7);
  constexpr double step = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const V point = randomPoint(random, 1.2);
    V gradient;
    surface.value(point, gradient);
    EXPECT_LE(gradient.norm(), 1.0 + 1e-12);
    for (int k = 0; k < 3; ++k) {
      const V offset = step * V::Unit(k);
      EXPECT_NEAR(gradient[k], (surface.value(point + offset) - surface.value(point - offset)) / (2 * step), 2e-3);
    }
  }
}

TEST(ImplicitSurface, DoesNotDependOnTheOrderOfTheCones)
{
  std::vector<RoundCone> cones = randomCones(30, 1);
  const ImplicitSurface surface(cones, 0.02);
  std::reverse(cones.begin(), cones.end());
  const ImplicitSurface reversed(cones, 0.02);
  RandomNumbers random(2);
  for (int i = 0; i < 200; ++i) {
    const V point = randomPoint(random, 1.2);
    EXPECT_NEAR(surface.value(point), reversed.value(point), 1e-12);
  }
}

TEST(ImplicitSurface, ProjectionEndsOnTheSurface)
{
  const ImplicitSurface surface({{V(0, 0, 0), 0.3, V(1, 0, 0), 0.2}, {V(1, 0, 0), 0.2, V(1, 1, 0), 0.15}}, 0.02);
  RandomNumbers random(4);
  for (int i = 0; i < 200; ++i) {
    const V near_axis(random.uniform(0.0, 1.0), random.uniform(0.18, 0.35), random.uniform(-0.2, 0.2));
    EXPECT_NEAR(surface.value(surface.project(near_axis)), 0.0, 1e-5);
  }
}

TEST(ImplicitSurface, BoxHoldsEveryPointInside)
{
  const ImplicitSurface surface(randomCones(30, 1), 0.05);
  RandomNumbers random(9);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const V point = randomPoint(random, 2.0);
    if (surface.value(point) > 0.0)
      continue;
    ++inside;
    EXPECT_TRUE((point.array() >= surface.lowest().array()).all() &&
                (point.array() <= surface.highest().array()).all());
  }
  EXPECT_GT(inside, 100);
}

} // namespace
