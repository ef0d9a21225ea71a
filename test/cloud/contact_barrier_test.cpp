#include "cloud/clouds.h"
#include "cloud/contact_barrier.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float depth = 0.01F;

/** Two points on top of a plane and one under the middle between them. */
struct Passage {
  Passage(float length, float height)
      : points{{0.0F, 0.0F, 0.0F}, {length, 0.0F, 0.0F}, {0.5F * length, 0.0F, height}},
        normals(3, Vector3{0.0F, 0.0F, 1.0F})
  {
  }

  bool
  isBarred() const
  {
    return ContactBarrier(points, normals, depth).isCrossedBy({0, 1, points[1][0]});
  }

  std::vector<Vector3> points;
  std::vector<Vector3> normals;
};

TEST(ContactBarrier, IsASurfaceInTheWayOfTheEdgeMovedInwards)
{
  for (const float depths : {3.0F, 8.0F, 8.1F, 20.0F, 40.0F}) {
    EXPECT_TRUE(Passage(depths * depth, -depth).isBarred()) << depths;
    EXPECT_FALSE(Passage(depths * depth, -2.0F * depth).isBarred()) << depths;
    EXPECT_FALSE(Passage(depths * depth, depth).isBarred()) << depths;
  }
}

TEST(ContactBarrier, HasTheSameVerdictForASlantedEdge)
{
  const auto slanted = [](const Vector3& p) {
    constexpr float s = 0.57735027F;
    return Vector3{s * p[0] - 0.70710678F * p[2], s * p[0] + 0.70710678F * p[2], s * p[0]};
  };
  for (const float height : {-1.0F, -2.0F}) {
    Passage passage(40.0F * depth, height * depth);
    for (std::vector<Vector3>* list : {&passage.points, &passage.normals}) {
      std::transform(list->begin(), list->end(), list->begin(), slanted);
    }
    EXPECT_EQ(passage.isBarred(), height == -1.0F);
  }
}

TEST(ContactBarrier, TellsNothingWherePointsAreMuchCloserThanTheDepth)
{
  // A crowd in the box around the edge, met before the point in the way, but not in the way itself.
  for (const std::size_t crowd : {100U, 2000U, 3000U}) {
    Passage passage(4.0F * depth, -depth);
    passage.points.insert(passage.points.end(), crowd, {0.4F * depth, 0.0F, -1.9F * depth});
    passage.normals.insert(passage.normals.end(), crowd, {0.0F, 0.0F, 1.0F});
    EXPECT_EQ(passage.isBarred(), crowd < 2048U) << crowd;
  }
}

TEST(ContactBarrier, DoesNotBarWhatIsMuchTooLongForAContact)
{
  EXPECT_FALSE(Passage(65.0F * depth, -depth).isBarred());
  EXPECT_TRUE(Passage(63.0F * depth, -depth).isBarred());
}

} // namespace
