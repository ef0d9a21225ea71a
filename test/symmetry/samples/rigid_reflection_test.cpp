#include "base/vector_math.h"
#include "symmetry/samples/rigid_reflection.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::symmetry;

namespace {

struct Place {
  Vector3 position;
  Vector3 normal;
};

/** Places all over an ellipsoid with three different axes. */
std::vector<Place>
ellipsoid(std::size_t count)
{
  std::mt19937 random(7);
  std::normal_distribution<float> gauss;
  const Vector3 axes{1.0F, 0.7F, 0.4F};
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 u = normalized({gauss(random), gauss(random), gauss(random)});
    places.push_back({{axes[0] * u[0], axes[1] * u[1], axes[2] * u[2]},
                      normalized({u[0] / axes[0], u[1] / axes[1], u[2] / axes[2]})});
  }
  return places;
}

RigidReflection
someReflection()
{
  RigidReflection reflection;
  reflection.linear = Eigen::AngleAxisf(0.8F, Eigen::Vector3f(0.6F, 0.0F, 0.8F)).toRotationMatrix() *
                      Eigen::Vector3f(1.0F, -1.0F, 1.0F).asDiagonal();
  reflection.shift = Eigen::Vector3f(0.3F, -0.2F, 1.5F);
  return reflection;
}

OrientedMatch
matchOf(const Place& place, const RigidReflection& reflection)
{
  return {place.position, place.normal, reflection(place.position), reflection.turned(place.normal), 1.0F};
}

TEST(FitReflection, FindsTheReflectionOfExactMatches)
{
  const RigidReflection truth = someReflection();
  std::vector<OrientedMatch> matches;
  for (const Place& place : ellipsoid(40)) {
    matches.push_back(matchOf(place, truth));
  }
  const RigidReflection found = fitReflection(matches, 0.1F);
  EXPECT_LT((found.linear - truth.linear).norm(), 1e-4F);
  EXPECT_LT((found.shift - truth.shift).norm(), 1e-4F);
  EXPECT_LT(found.error, 1e-8F);
}

TEST(FitReflection, NeverReturnsARotation)
{
  std::vector<OrientedMatch> matches;
  for (const Place& place : ellipsoid(40)) {
    matches.push_back({place.position, place.normal, place.position, place.normal, 1.0F});
  }
  const RigidReflection found = fitReflection(matches, 0.1F);
  EXPECT_NEAR(found.linear.determinant(), -1.0F, 1e-4F);
  EXPECT_GT(found.error, 0.01F); // the identity is not to be had
}

TEST(FitReflection, IsOrthogonalWhateverTheMatches)
{
  const Place place{{1.0F, 2.0F, 3.0F}, {0.0F, 0.0F, 1.0F}};
  const RigidReflection truth = someReflection();
  std::vector<OrientedMatch> line;
  for (const float x : {0.0F, 1.0F, 2.0F}) {
    line.push_back({{x, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, x, 0.0F}, {0.0F, 0.0F, 0.0F}, 1.0F});
  }
  for (const std::vector<OrientedMatch>& matches :
       {std::vector<OrientedMatch>{}, {matchOf(place, truth)}, {matchOf(place, truth), matchOf(place, truth)}, line}) {
    const RigidReflection found = fitReflection(matches, 0.1F);
    EXPECT_TRUE(found.shift.allFinite());
    EXPECT_LT((found.linear * found.linear.transpose() - Eigen::Matrix3f::Identity()).norm(), 1e-3F);
    EXPECT_NEAR(found.linear.determinant(), -1.0F, 1e-3F);
  }
}

TEST(FitReflection, SlidesMatchesOfNearestPlacesIntoPlace)
{
  const std::vector<Place> places = ellipsoid(3000);
  const RigidReflection truth = someReflection();
  RigidReflection reflection = truth;
  reflection.linear = Eigen::AngleAxisf(0.35F, Eigen::Vector3f::UnitZ()).toRotationMatrix() * truth.linear;
  // Iterative closest points from a start that is off by 20 degrees.
  for (int round = 0; round < 15; ++round) {
    std::vector<OrientedMatch> matches;
    for (std::size_t i = 0; i < 60; ++i) {
      const Vector3 image = reflection(places[i].position);
      OrientedMatch match = matchOf(places[i], reflection);
      float least = 1e9F;
      for (const Place& target : places) {
        const Vector3 there = truth(target.position);
        if (distance(there, image) < least) {
          least = distance(there, image);
          match.to = there;
          match.to_normal = truth.turned(target.normal);
        }
      }
      matches.push_back(match);
    }
    reflection = fitReflection(matches, 0.1F);
  }
  // The ellipsoid is a mirror image of itself in three planes, but those are far from the start.
  EXPECT_LT((reflection.linear - truth.linear).norm(), 0.1F);
  EXPECT_LT((reflection.shift - truth.shift).norm(), 0.05F);
}

} // namespace
