#include "support/coarse_body.h"
#include "support/with_threads.h"
#include "symmetry/sides/map_quality.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct KnownMap {
  Model model;
  PreparedSurface surface;
  float diameter = 0.0F;
};

const KnownMap&
human()
{
  static const KnownMap known = [] {
    KnownMap result;
    result.model = body(Body::Human, 1.0);
    result.surface = preparedMesh(result.model.surface);
    const std::vector<float> field = distanceField(result.surface.graph, 0);
    result.diameter = *std::max_element(field.begin(), field.end());
    return result;
  }();
  return known;
}

MapSummary
measure(const std::vector<Index>& partners)
{
  return measureMap(human().surface, partners, human().diameter);
}

TEST(MapQuality, OfTheTrueMapIsPerfect)
{
  const MapSummary summary = measure(human().model.partners);
  EXPECT_EQ(summary.matched, human().surface.size());
  EXPECT_EQ(summary.involution, 1.0F);
  EXPECT_LT(summary.inverted_faces, 0.01F); // faces at strong bends
  EXPECT_LT(summary.torn_faces, 0.005F);
  EXPECT_LT(summary.isometry_error, 0.02F);
}

TEST(MapQuality, OfTheIdentityTurnsNoFaceOver)
{
  std::vector<Index> identity(human().surface.size());
  std::iota(identity.begin(), identity.end(), 0);
  const MapSummary summary = measure(identity);
  EXPECT_GT(summary.inverted_faces, 0.98F);
  EXPECT_LT(summary.torn_faces, 0.01F); // only those with a longer edge to begin with
  EXPECT_EQ(summary.involution, 1.0F);
  EXPECT_EQ(summary.isometry_error, 0.0F);
}

TEST(MapQuality, OfAScatteredMapIsTorn)
{
  std::vector<Index> scattered(human().surface.size());
  for (std::size_t v = 0; v < scattered.size(); ++v) {
    scattered[v] = static_cast<Index>((v * 1237 + 11) % scattered.size());
  }
  const MapSummary summary = measure(scattered);
  EXPECT_GT(summary.torn_faces, 0.8F);
  EXPECT_LT(summary.involution, 0.1F);
  EXPECT_GT(summary.isometry_error, 0.1F);
}

TEST(MapQuality, CountsMatchedPointsOnly)
{
  std::vector<Index> partners = human().model.partners;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    partners[v] = v % 2 == 0 ? no_index : partners[v];
  }
  const MapSummary summary = measure(partners);
  EXPECT_EQ(summary.matched, human().surface.size() / 2);
  EXPECT_LE(summary.involution, 1.0F);
  const MapSummary none = measure(std::vector<Index>(partners.size(), no_index));
  EXPECT_EQ(none.matched, 0U);
  EXPECT_EQ(none.involution, 0.0F);
}

TEST(MapQuality, IsTheSameForAnyNumberOfThreads)
{
  EXPECT_EQ(measure(human().model.partners).isometry_error,
            withThreads(5, [] { return measure(human().model.partners); }).isometry_error);
}

} // namespace
