#include "support/sample_partners.h"
#include "support/with_threads.h"
#include "symmetry/refine/bidirectional_matches.h"
#include "symmetry/refine/extremity_rotations.h"
#include "symmetry/refine/patch_alignment.h"
#include "symmetry/refine/point_map.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Every partner replaced by some point of a cell adjacent to its own. */
std::vector<Index>
scattered(const CoarseBody& body, std::vector<Index> partners)
{
  std::mt19937 random(3);
  const SurfaceGraph& graph = body.coarse.graph;
  for (Index& partner : partners) {
    const Index cell = body.coarse.cells.owner[partner];
    const std::uint32_t degree = graph.offsets[cell + 1] - graph.offsets[cell];
    partner = body.coarse.cells.vertices[graph.neighbours[graph.offsets[cell] + random() % degree]];
  }
  return partners;
}

Index
nearestPoint(const CoarseBody& body, const Vector3& place)
{
  Index best = 0;
  for (std::size_t v = 1; v < body.surface.size(); ++v) {
    if (distance(body.surface.points[v], place) < distance(body.surface.points[best], place)) {
      best = static_cast<Index>(v);
    }
  }
  return best;
}

/** The tip that the true map leaves nearest to where it is: the top of the head. */
Index
topOfHead(const CoarseBody& body)
{
  const SampleMap truth = body.trueMap();
  Index best = body.landmarks.extremities.front();
  for (const Index tip : body.landmarks.extremities) {
    if (body.landmarks.distances(tip, truth[tip]) < body.landmarks.distances(best, truth[best])) {
      best = tip;
    }
  }
  return best;
}

/** The true partners, but in the head turned about its axis. */
std::vector<Index>
withTurnedHead(const CoarseBody& body, float radius, float angle)
{
  std::vector<Index> partners = truePartners(body);
  const Index tip = topOfHead(body);
  const SurfacePatch head = patchAround(body.coarse, tip, radius);
  Vector3 middle{0.0F, 0.0F, 0.0F};
  for (const PatchMember& member : head) {
    middle = middle + (1.0F / static_cast<float>(head.size())) * body.coarse.points[member.sample];
  }
  const Vector3 axis = normalized(body.coarse.points[tip] - middle);
  const Eigen::AngleAxisf turn(angle, Eigen::Vector3f(axis[0], axis[1], axis[2]));
  for (const PatchMember& member : head) {
    const Vector3 arm = body.surface.points[partners[member.sample]] - middle;
    const Eigen::Vector3f turned = turn * Eigen::Vector3f(arm[0], arm[1], arm[2]);
    partners[member.sample] = nearestPoint(body, middle + Vector3{turned.x(), turned.y(), turned.z()});
  }
  return partners;
}

constexpr PatchSize small_patches{0.12F, 250};

TEST(PatchAround, HoldsTheSamplesWithinTheRadius)
{
  const CoarseBody& body = human();
  const float radius = 0.2F * body.landmarks.diameter;
  const std::vector<float> field = distanceField(body.coarse.graph, 5);
  const SurfacePatch patch = patchAround(body.coarse, 5, radius);
  std::size_t next = 0;
  for (std::size_t i = 0; i < body.coarse.size(); ++i) {
    if (field[i] < radius) {
      ASSERT_LT(next, patch.size());
      EXPECT_EQ(patch[next].sample, static_cast<Index>(i));
      const float share = field[i] / radius;
      EXPECT_NEAR(patch[next].weight, (1.0F - share * share) * (1.0F - share * share), 1e-4F);
      ++next;
    }
  }
  EXPECT_EQ(next, patch.size());
}

TEST(MutualPartners, DrawAScatteredMapTogether)
{
  const CoarseBody& body = human();
  const std::vector<Index> rough = scattered(body, truePartners(body));
  const std::vector<Index> smooth = mutualPartners(body.sampled(), rough, 3);
  EXPECT_LT(errorOf(body, smooth), 0.6F * errorOf(body, rough));
  EXPECT_EQ(smooth, withThreads(5, [&] { return mutualPartners(body.sampled(), rough, 3); }));
}

TEST(BidirectionalMatches, AreReadBothWays)
{
  const CoarseBody& body = human();
  const std::vector<Index> truth = truePartners(body);
  const std::vector<Index>& samples = body.coarse.cells.vertices;
  // One half knows its partners, the other one is lost: all of it is sent to one point.
  const Index nowhere = samples[0];
  std::vector<Index> partners = truth;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (samples[i] > truth[i]) {
      partners[i] = nowhere;
    }
  }
  const BidirectionalMatches matches(body.surface, body.coarse, partners);
  float from_nowhere = 0.0F;
  float from_truth = 0.0F;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (samples[i] < truth[i]) {
      const Vector3 image = matches.imageOf(truth[i]);
      from_nowhere += distance(body.surface.points[nowhere], body.surface.points[samples[i]]);
      from_truth += distance(image, body.surface.points[samples[i]]);
    }
  }
  EXPECT_LT(from_truth, 0.7F * from_nowhere); // the half that knows speaks for both
}

TEST(PatchAlignment, BringsAScatteredMapIntoPlace)
{
  const CoarseBody& body = human();
  const SampledSurface sampled = body.sampled();
  const PatchAlignment alignment(sampled, small_patches);
  const std::vector<Index> rough = scattered(body, truePartners(body));
  const std::vector<Index> aligned = alignment.align(rough, 5);
  EXPECT_GT(errorOf(body, rough), 0.9F);
  EXPECT_LT(errorOf(body, aligned), 0.2F);
  EXPECT_EQ(aligned, withThreads(5, [&] { return PatchAlignment(sampled, small_patches).align(rough, 5); }));
  EXPECT_EQ(rough, alignment.align(rough, 0));
}

TEST(PatchAlignment, FitsTellTheTrueMapFromOthers)
{
  const CoarseBody& body = human();
  const SampledSurface sampled = body.sampled();
  const PatchAlignment alignment(sampled, small_patches);
  const auto mean_fit = [&](const std::vector<Index>& partners) {
    PatchFit mean{0.0F, 0.0F};
    for (const PatchFit& fit : alignment.fits(partners)) {
      mean.distance += fit.distance / 250.0F;
      mean.turn += fit.turn / 250.0F;
    }
    return mean;
  };
  const PatchFit of_truth = mean_fit(truePartners(body));
  const PatchFit of_identity = mean_fit(body.coarse.cells.vertices);
  EXPECT_LT(of_truth.distance, 0.01F);
  EXPECT_LT(of_truth.turn, 0.05F);
  EXPECT_GT(of_identity.distance, 2.0F * of_truth.distance);
  EXPECT_GT(of_identity.turn, 3.0F * of_truth.turn);
}

TEST(RotateExtremities, TurnsATwistedHeadBack)
{
  const CoarseBody& body = human();
  const float radius = 0.12F * body.landmarks.diameter;
  const std::vector<Index> extremities{topOfHead(body)};
  const PatchFitting fitting(body.coarse);
  for (const float angle : {-1.6F, 1.2F}) {
    const std::vector<Index> twisted = withTurnedHead(body, radius, angle);
    std::vector<Index> partners = twisted;
    EXPECT_EQ(rotateExtremities(body.sampled(), fitting, extremities, radius, partners), 1U);
    EXPECT_LT(errorOf(body, partners), 0.5F * errorOf(body, twisted)) << angle;
    std::vector<Index> again = twisted;
    withThreads(3, [&] { return rotateExtremities(body.sampled(), fitting, extremities, radius, again); });
    EXPECT_EQ(partners, again);
  }
}

TEST(RotateExtremities, LeavesTheTrueMapAlone)
{
  const CoarseBody& body = human();
  const PatchFitting fitting(body.coarse);
  std::vector<Index> partners = truePartners(body);
  EXPECT_EQ(
      rotateExtremities(body.sampled(), fitting, body.landmarks.extremities, 0.12F * body.landmarks.diameter, partners),
      0U);
  EXPECT_EQ(partners, truePartners(body));
  EXPECT_EQ(rotateExtremities(body.sampled(), fitting, {}, 0.1F, partners), 0U);
}

} // namespace
