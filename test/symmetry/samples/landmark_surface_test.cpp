#include "support/human.h"
#include "support/with_threads.h"
#include "symmetry/samples/landmark_surface.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(LandmarkSurface, DistancesAreSymmetricAndObeyTheTriangleInequality)
{
  const Eigen::MatrixXf& d = human().landmarks.distances;
  ASSERT_EQ(d.rows(), 250);
  EXPECT_EQ((d - d.transpose()).norm(), 0.0F);
  EXPECT_EQ(d.diagonal().norm(), 0.0F);
  EXPECT_EQ(human().landmarks.diameter, d.maxCoeff());
  for (Eigen::Index i = 0; i < d.rows(); i += 7) {
    for (Eigen::Index j = 0; j < d.rows(); j += 5) {
      EXPECT_LE(d(i, j), (d.col(i) + d.col(j)).minCoeff() + 1e-4F);
    }
  }
}

TEST(LandmarkSurface, DistancesAreNearThoseOfTheSurface)
{
  const CoarseBody& body = human();
  double relative = 0.0;
  std::size_t count = 0;
  for (Index i = 0; i < 250; i += 25) {
    const std::vector<float> exact = distanceField(body.surface.graph, body.coarse.cells.vertices[i]);
    for (Index j = 0; j < 250; ++j) {
      if (i != j) {
        relative += body.landmarks.distances(i, j) / exact[body.coarse.cells.vertices[j]] - 1.0;
        ++count;
      }
    }
  }
  relative /= static_cast<double>(count);
  EXPECT_GE(relative, 0.0); // a way through samples is never shorter
  EXPECT_LE(relative, 0.15);
}

TEST(LandmarkSurface, EuclideanDistancesAreStraight)
{
  const CoarseBody& body = human();
  const LandmarkSurface straight =
      withThreads(2, [&] { return makeLandmarkSurface(body.coarse, 100, Metric::Euclidean); });
  for (Index i = 0; i < 100; i += 9) {
    for (Index j = 0; j < 100; ++j) {
      EXPECT_FLOAT_EQ(straight.distances(i, j), distance(straight.points[i], straight.points[j]));
    }
  }
}

TEST(LandmarkSurface, ExtremitiesAreFarOutAndComeInPairs)
{
  const LandmarkSurface& landmarks = human().landmarks;
  ASSERT_GE(landmarks.extremities.size(), 4U);
  ASSERT_LE(landmarks.extremities.size(), 10U);
  EXPECT_EQ(landmarks.average_distance[landmarks.extremities[0]],
            *std::max_element(landmarks.average_distance.begin(), landmarks.average_distance.end()));
  for (std::size_t i = 1; i < landmarks.extremities.size(); ++i) {
    EXPECT_GE(landmarks.average_distance[landmarks.extremities[i - 1]],
              landmarks.average_distance[landmarks.extremities[i]]);
  }
  // The four farthest out are on hands and feet: the partner of each is near an extremity, too.
  const SampleMap map = human().trueMap();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NE(trueSide(landmarks.extremities[i]), 0);
    const Index partner = map[landmarks.extremities[i]];
    EXPECT_TRUE(std::any_of(landmarks.extremities.begin(), landmarks.extremities.end(), [&](Index other) {
      return landmarks.distances(partner, other) < 0.1F * landmarks.diameter;
    })) << i;
  }
}

TEST(ComparableLandmarks, AreThoseThatHaveNoHoleAtEitherEnd)
{
  LandmarkSurface landmarks;
  landmarks.at_hole = {0, 1, 0, 0, 0};
  EXPECT_EQ(comparableLandmarks(landmarks, {0, 2, 1, 4, 3}), (std::vector<char>{1, 0, 0, 1, 1}));
}

TEST(ComparableLandmarks, AreAllWhereHolesLeaveHardlyAny)
{
  LandmarkSurface landmarks;
  landmarks.at_hole = {1, 1, 1, 1, 1, 0};
  EXPECT_EQ(comparableLandmarks(landmarks, {1, 0, 3, 2, 5, 4}), std::vector<char>(6, 1));
}

} // namespace
