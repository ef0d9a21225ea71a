#include "base/vector_math.h"
#include "geodesic/surface_metric.h"
#include "support/graphs.h"
#include "support/with_threads.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

TEST(GeodesicMetric, MeasuresAlongTheSurface)
{
  const Surface sphere = sphereMesh(4);
  const SurfaceGraph graph = meshGraph(sphere);
  const GeodesicMetric metric(graph);
  EXPECT_EQ(metric.fields({4, 9}).values, distanceFields(graph, {4, 9}).values);
  const Index middle =
      metric.midpoints({4}, metric.fields({4}), {0}).front(); // from (0, 0, 1) to (1, 0, 0), along the great circle
  EXPECT_NEAR(sphere.points[middle][0], std::sqrt(0.5F), 0.05F);
  EXPECT_NEAR(sphere.points[middle][2], std::sqrt(0.5F), 0.05F);
}

TEST(EuclideanMetric, MeasuresStraightThroughSpace)
{
  const Surface sphere = sphereMesh(3);
  const EuclideanMetric metric(sphere.points);
  const DistanceFields fields = metric.fields({4, 17});
  ASSERT_EQ(fields.rows(), 2U);
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    EXPECT_EQ(fields.row(0)[v], distance(sphere.points[4], sphere.points[v]));
    EXPECT_EQ(fields.row(1)[v], distance(sphere.points[17], sphere.points[v]));
  }
  EXPECT_FLOAT_EQ(fields.row(0)[5], 2.0F); // pole to pole
}

TEST(EuclideanMetric, MidpointIsTheVertexNearestToTheMiddle)
{
  const std::vector<Vector3> points = {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 0.5F}};
  EXPECT_EQ(EuclideanMetric(points).midpoints({0, 0}, {}, {1, 0}), (std::vector<Index>{3, 0}));
}

TEST(EuclideanMetric, SamplesFarthestPointsAsDefined)
{
  const Surface torus = torusMesh(30, 12, 2.0F, 0.7F);
  const std::vector<Index> samples = EuclideanMetric(torus.points).farthestPoints(7, 40);
  ASSERT_EQ(samples.size(), 40U);
  EXPECT_EQ(samples.front(), 7);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto nearest = [&](Index v) {
      float least = unreachable;
      for (std::size_t j = 0; j < i; ++j) {
        least = std::min(least, distance(torus.points[v], torus.points[samples[j]]));
      }
      return least;
    };
    for (Index v = 0; v < static_cast<Index>(torus.size()); ++v) {
      const bool fits = nearest(v) < nearest(samples[i]) || (nearest(v) == nearest(samples[i]) && v >= samples[i]);
      ASSERT_TRUE(fits) << "sample " << i << ": vertex " << v << " is farther";
    }
  }
}

TEST(EuclideanMetric, EndsSamplingAtDuplicates)
{
  EXPECT_EQ(EuclideanMetric({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}).farthestPoints(0, 3), (std::vector<Index>{0, 1}));
}

TEST(SurfaceMetric, DoesNotDependOnTheNumberOfThreads)
{
  const Surface sphere = sphereMesh(3);
  const SurfaceGraph graph = meshGraph(sphere);
  const std::vector<Index> sources = {0, 2, 33, 5, 100};
  const std::vector<Index> targets = {1, 9, 70, 5, 4};
  const GeodesicMetric geodesic(graph);
  const EuclideanMetric euclidean(sphere.points);
  for (const SurfaceMetric* metric :
       {static_cast<const SurfaceMetric*>(&geodesic), static_cast<const SurfaceMetric*>(&euclidean)}) {
    const DistanceFields fields = metric->fields(sources);
    EXPECT_EQ(withThreads(4, [&] { return metric->fields(sources); }).values, fields.values);
    EXPECT_EQ(metric->midpoints(sources, fields, targets),
              withThreads(4, [&] { return metric->midpoints(sources, fields, targets); }));
  }
}
