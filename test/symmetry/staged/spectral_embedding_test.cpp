#include "geodesic/surface_metric.h"
#include "support/shapes.h"
#include "symmetry/staged/spectral_embedding.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Distances that are those of points in space already are reproduced by as many coordinates. */
TEST(SpectralEmbedding, ReproducesStraightDistances)
{
  const Surface sphere = scaled(sphereMesh(3), {1.0F, 2.0F, 4.0F});
  const EuclideanMetric metric(sphere.points);
  const std::vector<Index> landmarks = metric.farthestPoints(0, 20);
  const SpectralEmbedding embedding = embedByLandmarks(metric.fields(landmarks), landmarks, 3);
  ASSERT_EQ(embedding.dimensions, 3);
  for (std::size_t v = 0; v < sphere.size(); v += 7) {
    for (std::size_t w = 0; w < sphere.size(); w += 11) {
      float embedded = 0.0F;
      float straight = 0.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        embedded += std::pow(embedding.at(v)[k] - embedding.at(w)[k], 2.0F);
        straight += std::pow(sphere.points[v][k] - sphere.points[w][k], 2.0F);
      }
      ASSERT_NEAR(std::sqrt(embedded), std::sqrt(straight), 1e-3F) << v << " and " << w;
    }
  }
  EXPECT_GT(embedding.eigenvalues[0], embedding.eigenvalues[1]);
  EXPECT_GT(embedding.eigenvalues[1], embedding.eigenvalues[2]);
}

TEST(SpectralEmbedding, HasNoMoreDimensionsThanThePoints)
{
  const Surface grid = gridMesh(9, 5);
  const EuclideanMetric metric(grid.points);
  const std::vector<Index> landmarks = metric.farthestPoints(0, 12);
  const SpectralEmbedding embedding = embedByLandmarks(metric.fields(landmarks), landmarks, 6);
  for (std::size_t k = 2; k < embedding.eigenvalues.size(); ++k) {
    EXPECT_LT(embedding.eigenvalues[k], 1e-4F * embedding.eigenvalues[0]); // rounding, where any are left
  }
}

} // namespace
