#include "support/coarse_body.h"
#include "symmetry/confidence/point_confidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

TEST(WithMapConfidence, FollowsTheMapAndComesBack)
{
  for (const float of_point : {0.01F, 0.4F, 0.97F}) {
    const float lowered = withMapConfidence(of_point, 0.9F, 0.3F);
    EXPECT_LT(lowered, of_point);
    EXPECT_GT(lowered, 0.0F);
    EXPECT_NEAR(withMapConfidence(lowered, 0.3F, 0.9F), of_point, 1e-5F);
    EXPECT_FLOAT_EQ(withMapConfidence(of_point, 0.6F, 0.6F), of_point);
  }
}

TEST(WithMapConfidence, LeavesAloneWhatHasNoPartner)
{
  EXPECT_EQ(withMapConfidence(0.0F, 0.2F, 1.0F), 0.0F);
  EXPECT_LE(withMapConfidence(1.0F, 0.0F, 1.0F), 1.0F);
}

TEST(PointConfidences, FollowTheEvidenceAroundEachPoint)
{
  const Surface body = test::bentHuman().surface;
  const PreparedSurface surface = test::preparedMesh(body);
  StepTimer timer;
  const SampledSurface sampled = sampleSurface(surface, {}, Metric::Geodesic, timer);
  std::vector<PointEvidence> evidence(sampled.landmarks.size(), {0.1F, 0.004F, 1.0F});
  const std::vector<float> sure = pointConfidences(sampled, evidence, 0.95F);
  ASSERT_EQ(sure.size(), surface.size());
  EXPECT_GT(*std::min_element(sure.begin(), sure.end()), 0.8F);
  // Torn and turned over around one landmark: there alone.
  evidence[0] = {1.0F, 0.05F, -1.0F};
  const std::vector<float> doubted = pointConfidences(sampled, evidence, 0.95F);
  const auto changed = [&](std::size_t v) {
    return doubted[v] < 0.95F * sure[v];
  };
  std::size_t near = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Index landmark = sampled.landmarks.nearest_landmark[sampled.coarse.cells.owner[v]];
    near += landmark == 0 ? 1U : 0U;
    EXPECT_FALSE(changed(v) && sampled.landmarks.distances(0, landmark) > 0.1F * sampled.landmarks.diameter) << v;
  }
  EXPECT_TRUE(changed(static_cast<std::size_t>(sampled.coarse.cells.vertices[0])));
  EXPECT_GT(near, 0U);
  // And everywhere where the map is doubted as a whole.
  const std::vector<float> unsure =
      pointConfidences(sampled, std::vector<PointEvidence>(evidence.size(), evidence[1]), 0.3F);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    EXPECT_LT(unsure[v], sure[v]);
  }
}

} // namespace
} // namespace symmetry
} // namespace pcl
