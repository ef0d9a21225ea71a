// Which way is up: a body stands on its legs, along an axis of its file.
#include "base/vector_math.h"
#include "picture/upright.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;

namespace {

const Vector3 sideways = {1.0F, 0.0F, 0.0F};

/** Points of a box, evenly. */
void
addBox(std::vector<Vector3>& points, const Vector3& from, const Vector3& to)
{
  constexpr int steps = 6;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k)
        points.push_back({from[0] + static_cast<float>(i) / steps * (to[0] - from[0]),
                          from[1] + static_cast<float>(j) / steps * (to[1] - from[1]),
                          from[2] + static_cast<float>(k) / steps * (to[2] - from[2])});
}

/** A trunk along y with four legs down z, a head and a tail in the mirror plane x = 0. */
std::vector<Vector3>
animal()
{
  std::vector<Vector3> points;
  addBox(points, {-0.3F, -1.0F, 1.0F}, {0.3F, 1.0F, 1.6F});
  for (const float x : {-0.3F, 0.2F})
    for (const float y : {-0.9F, 0.8F})
      addBox(points, {x, y, 0.0F}, {x + 0.1F, y + 0.1F, 1.0F});
  addBox(points, {-0.05F, 1.0F, 1.5F}, {0.05F, 2.2F, 1.6F});
  addBox(points, {-0.15F, -1.6F, 1.5F}, {0.15F, -1.0F, 2.0F});
  return points;
}

/** A trunk and a head up y on two legs with feet towards z, and arms. */
std::vector<Vector3>
person()
{
  std::vector<Vector3> points;
  addBox(points, {-0.2F, 0.8F, -0.1F}, {0.2F, 1.5F, 0.1F});
  addBox(points, {-0.1F, 1.5F, -0.1F}, {0.1F, 1.8F, 0.1F});
  for (const float x : {-0.2F, 0.1F})
    addBox(points, {x, 0.0F, -0.1F}, {x + 0.1F, 0.8F, 0.05F});
  for (const float x : {-0.2F, 0.1F})
    addBox(points, {x, 0.0F, -0.1F}, {x + 0.1F, 0.05F, 0.25F});
  return points;
}

std::vector<Vector3>
turned(std::vector<Vector3> points, float sign) // what was up z is up y, or the other way round
{
  for (Vector3& p : points)
    p = {p[0], sign * p[2], -sign * p[1]};
  return points;
}

TEST(Upright, IsWhereAnAnimalStandsOnItsLegs)
{
  EXPECT_GT(uprightDirection(animal(), sideways)[2], 0.99F);
  EXPECT_GT(uprightDirection(turned(animal(), 1.0F), sideways)[1], 0.99F);
}

TEST(Upright, IsWhereAPersonStandsOnItsFeet)
{
  EXPECT_GT(uprightDirection(person(), sideways)[1], 0.99F);
  EXPECT_GT(uprightDirection(turned(person(), -1.0F), sideways)[2], 0.99F);
}

TEST(Upright, IsPerpendicularToTheLateralDirection)
{
  const Vector3 lateral = normalized(Vector3{1.0F, 0.1F, 0.2F});
  const Vector3 up = uprightDirection(animal(), lateral);
  EXPECT_NEAR(dot(up, lateral), 0.0F, 1e-6F);
  EXPECT_NEAR(norm(up), 1.0F, 1e-6F);
}

TEST(Upright, CannotBeToldOfNothingOrOfWhatIsObliqueToAllAxes)
{
  EXPECT_EQ(norm(uprightDirection(animal(), normalized(Vector3{1.0F, 1.0F, 1.0F}))), 0.0F);
  EXPECT_EQ(norm(uprightDirection({}, sideways)), 0.0F);
}

} // namespace
