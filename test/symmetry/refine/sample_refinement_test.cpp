#include "support/coarse_body.h"
#include "support/with_threads.h"
#include "symmetry/refine/map_misfit.h"
#include "symmetry/refine/sample_refinement.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A candidate whose matrix is the action of a map of the landmarks on 20 eigenfunctions. */
SymmetryCandidate
candidateOf(const CoarseBody& body, const SampleMap& map)
{
  const auto landmarks = static_cast<Eigen::Index>(map.size());
  const Eigen::MatrixXf functions = body.basis.functions.topLeftCorner(landmarks, 20);
  Eigen::MatrixXf images(landmarks, functions.cols());
  for (Eigen::Index i = 0; i < landmarks; ++i) {
    images.row(i) = functions.row(map[static_cast<std::size_t>(i)]);
  }
  SymmetryCandidate candidate;
  candidate.map = map;
  candidate.matrix =
      nearestInvolution((functions.transpose() * functions).ldlt().solve(functions.transpose() * images));
  return candidate;
}

RefinementSettings
settingsFor(const CoarseBody& body)
{
  RefinementSettings settings;
  settings.levels = {20, 30, static_cast<int>(body.basis.functions.cols())};
  settings.patches = {{0.14F, 80}, {0.1F, 160}};
  return settings;
}

TEST(SampleRefinement, LeadsFromARoughMapToTheTruePartners)
{
  const CoarseBody body = coarseBody(Body::Human, 1.0);
  const RefinementSettings settings = settingsFor(body);
  const auto refine = [&](const SampleMap& map) {
    const SampledSurface sampled = body.sampled();
    return SampleRefinement(sampled, settings).refine(candidateOf(body, map));
  };
  const SampleEstimate found = refine(body.trueMap());
  ASSERT_EQ(found.partners.size(), body.coarse.size());
  float error = 0.0F;
  for (std::size_t i = 0; i < found.partners.size(); ++i) {
    const Index truth = body.model.partners[body.coarse.cells.vertices[i]];
    error += distance(body.surface.points[found.partners[i]], body.surface.points[truth]);
    EXPECT_EQ(found.map[i], body.coarse.cells.owner[found.partners[i]]);
  }
  EXPECT_LT(error / static_cast<float>(found.partners.size()), 0.2F * sampleSpacing(body.coarse));
  EXPECT_EQ(found.partners, withThreads(4, [&] { return refine(body.trueMap()); }).partners);

  SampleMap nobody_moves(body.landmarks.size());
  std::iota(nobody_moves.begin(), nobody_moves.end(), 0);
  EXPECT_LT(found.value, refine(nobody_moves).value);
}

TEST(SampleRefinement, ItsValueHasTheFitTheDisplacementAndTheMovedEndsInIt)
{
  const CoarseBody body = coarseBody(Body::Human, 1.0);
  const SampledSurface sampled = body.sampled();
  RefinementSettings settings = settingsFor(body);
  const SampleEstimate found = SampleRefinement(sampled, settings).refine(candidateOf(body, body.trueMap()));
  const float fit = logMisfit(found.fits, found.fit, settings.median_turn);
  const float displacement = found.score.log_displacement;
  ASSERT_LT(displacement, -0.5F);
  ASSERT_EQ(found.moved_ends, 1.0F) << "hands and feet";
  EXPECT_NEAR(found.value,
              found.score.value + settings.fit * fit - settings.displacement * displacement - settings.moved_ends,
              1e-4F);
  settings.displacement = 0.0F;
  const SampleEstimate without = SampleRefinement(sampled, settings).refine(candidateOf(body, body.trueMap()));
  EXPECT_GT(found.value, without.value + 0.2F) << "what moves less than a fifth of the diameter";
}

/** Of two candidates with the same score the one that leaves the limbs where they are promises less. */
TEST(SampleRefinement, ACandidateThatMovesTheEndsPromisesMore)
{
  const CoarseBody body = coarseBody(Body::Human, 1.0);
  const SampledSurface sampled = body.sampled();
  const RefinementSettings settings = settingsFor(body);
  const SampleRefinement refinement(sampled, settings);
  SymmetryCandidate candidate = candidateOf(body, body.trueMap());
  candidate.score.value = -1.0F;
  EXPECT_FLOAT_EQ(refinement.promise(candidate), -1.0F - settings.moved_ends_of_candidates);
  std::iota(candidate.map.begin(), candidate.map.end(), 0);
  EXPECT_FLOAT_EQ(refinement.promise(candidate), -1.0F);
}

} // namespace
