#include "support/human.h"
#include "symmetry/confidence/calibration.h"
#include "symmetry/confidence/map_asymmetry.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/search/symmetry_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct Finding {
  MapScore score;
  AsymmetryMeasures measures;
  float confidence = 0.0F;
};

Finding
judge(const CoarseBody& body, const SampleMap& map)
{
  const ShapeDescriptor descriptor = describeShape(body.coarse, body.basis, 8, DescriptorWeights{});
  Finding finding;
  finding.score = scoreMap(body.landmarks, descriptor, map, map.size(), ScoreWeights{});
  finding.measures = findAsymmetry(body.landmarks, descriptor.curvature, map);
  finding.confidence = candidateConfidence(finding.score, finding.measures);
  return finding;
}

/** The best map that the search finds. */
Finding
judgeBest(Body kind)
{
  const CoarseBody body = coarseBody(kind, 1.0);
  return judge(body, searchSymmetries(body.sampled(), SearchSettings{}).at(0).map);
}

TEST(FindAsymmetry, SeesNoneInTheIdentity)
{
  SampleMap map(human().landmarks.size());
  std::iota(map.begin(), map.end(), 0);
  const AsymmetryMeasures measures = judge(human(), map).measures;
  EXPECT_EQ(measures.stretch, 0.0F);
  EXPECT_EQ(measures.involution, 0.0F);
  EXPECT_EQ(measures.average_distance, 0.0F);
  EXPECT_EQ(measures.curvature, 0.0F);
  EXPECT_EQ(measures.concentration, 1.0F);
}

TEST(FindAsymmetry, SeesMoreStretchWhereALimbIsMissingOrTooMuch)
{
  const float symmetric = judgeBest(Body::Human).measures.stretch;
  EXPECT_GT(judgeBest(Body::MissingArm).measures.stretch, 1.5F * symmetric);
  EXPECT_GT(judgeBest(Body::ThirdArm).measures.stretch, 1.5F * symmetric);
}

TEST(FindAsymmetry, SeesWhatIsSentNearerToTheMiddle)
{
  EXPECT_LT(judge(human(), human().trueMap()).measures.average_distance, 0.05F);
  const LandmarkSurface& landmarks = human().landmarks;
  const auto middle = std::min_element(landmarks.average_distance.begin(), landmarks.average_distance.end());
  const auto outermost = std::max_element(landmarks.average_distance.begin(), landmarks.average_distance.end());
  const SampleMap all_to_the_middle(landmarks.size(), static_cast<Index>(middle - landmarks.average_distance.begin()));
  const float most = (*outermost - *middle) / landmarks.diameter;
  const float average_distance = judge(human(), all_to_the_middle).measures.average_distance;
  EXPECT_LE(average_distance, most);
  EXPECT_GT(average_distance, 0.8F * most) << "of the worst 3 %";
}

TEST(FindAsymmetry, DoesNotCountATearThatRelaxationHeals)
{
  SampleMap torn = human().trueMap();
  const AsymmetryMeasures whole = judge(human(), torn).measures;
  Eigen::Index far = 0;
  human().landmarks.distances.col(torn[20]).maxCoeff(&far);
  torn[20] = static_cast<Index>(far);
  const AsymmetryMeasures measures = judge(human(), torn).measures;
  EXPECT_NEAR(measures.stretch, whole.stretch, 0.1F * whole.stretch);
  EXPECT_GT(measures.concentration, whole.concentration);
}

TEST(FindAsymmetry, DoesNotDependOnTheLengthUnit)
{
  CoarseBody larger = human();
  larger.landmarks.distances *= 4.0F;
  larger.landmarks.diameter *= 4.0F;
  for (float& average_distance : larger.landmarks.average_distance) {
    average_distance *= 4.0F;
  }
  const AsymmetryMeasures small = judge(human(), human().trueMap()).measures;
  const AsymmetryMeasures large = judge(larger, human().trueMap()).measures;
  EXPECT_NEAR(large.stretch, small.stretch, 1e-4F);
  EXPECT_NEAR(large.involution, small.involution, 1e-5F);
  EXPECT_NEAR(large.average_distance, small.average_distance, 1e-5F);
  EXPECT_NEAR(large.concentration, small.concentration, 1e-3F);
}

TEST(CandidateConfidence, IsHighOnSymmetricBodiesAndLowWhereALimbIsMissingOrTooMuch)
{
  for (const Body kind : {Body::Human, Body::Quadruped, Body::Bird}) {
    EXPECT_GT(judgeBest(kind).confidence, 0.7F) << toString(kind);
  }
  for (const Body kind : {Body::MissingArm, Body::ThirdArm, Body::Hand, Body::Helix}) {
    EXPECT_LT(judgeBest(kind).confidence, 0.3F) << toString(kind);
  }
}

TEST(CandidateConfidence, FallsWithEverySignOfAsymmetryAndWithWhatStandsStill)
{
  Finding finding = judge(human(), human().trueMap());
  const auto changed = [&](float AsymmetryMeasures::*sign) {
    AsymmetryMeasures measures = finding.measures;
    measures.*sign *= 1.5F;
    return candidateConfidence(finding.score, measures);
  };
  EXPECT_LT(changed(&AsymmetryMeasures::stretch), finding.confidence);
  EXPECT_LT(changed(&AsymmetryMeasures::concentration), finding.confidence);
  EXPECT_LT(changed(&AsymmetryMeasures::curvature), finding.confidence);
  finding.score.fixed += 0.1F;
  EXPECT_LT(candidateConfidence(finding.score, finding.measures), finding.confidence);
}

/** The medians of right maps of scanned bodies. */
MapEvidence
evidenceOfRightMap()
{
  MapEvidence right;
  right.score.fixed = 0.16F;
  right.score.distorted = 0.0F;
  right.rough_curvature = 0.3F;
  right.measures.stretch = 0.069F;
  right.measures.involution = 0.009F;
  right.measures.average_distance = 0.025F;
  right.fit = {0.0035F, 0.047F};
  right.worst_distance = 0.009F;
  return right;
}

TEST(MapConfidence, FallsWithWhatSpeaksAgainstARightMap)
{
  const MapEvidence right = evidenceOfRightMap();
  const float confidence = mapConfidence(right);
  EXPECT_GT(confidence, 0.9F);

  const auto after = [&](const auto& change) {
    MapEvidence other = right;
    change(other);
    return mapConfidence(other);
  };
  EXPECT_LT(after([](MapEvidence& e) { e.fit.distance *= 1.5F; }), confidence);
  EXPECT_LT(after([](MapEvidence& e) { e.worst_distance *= 2.0F; }), confidence);
  EXPECT_LT(after([](MapEvidence& e) { e.rough_curvature += 0.3F; }), confidence);
  EXPECT_LT(after([](MapEvidence& e) { e.measures.stretch *= 2.0F; }), confidence);
}

TEST(MapConfidence, AllowsForWhatIsBadlyKnown)
{
  MapEvidence evidence = evidenceOfRightMap();
  evidence.measures.stretch *= 3.0F;
  const float confidence = mapConfidence(evidence);
  evidence.is_noisy = true;
  const float noisy = mapConfidence(evidence);
  EXPECT_GT(noisy, confidence);
  const auto at = [&](float share) {
    evidence.at_holes = share;
    return mapConfidence(evidence);
  };
  EXPECT_EQ(at(0.01F), noisy);
  EXPECT_GT(at(0.05F), noisy);
  EXPECT_GT(at(0.08F), at(0.05F));
  EXPECT_EQ(at(0.3F), at(0.08F));
}

TEST(MapConfidence, WhatNormalisesExplainsNoMoreThanOfRightMaps)
{
  const MapCalibration bounds;
  MapEvidence evidence = evidenceOfRightMap();
  evidence.measures.stretch *= 4.0F; // so that the confidence is not near 1
  const auto of = [&](float turn, float average_distance, float involution) {
    evidence.fit.turn = turn;
    evidence.measures.average_distance = average_distance;
    evidence.measures.involution = involution;
    return mapConfidence(evidence);
  };
  const float turn = bounds.turn_bound;
  const float average = bounds.average_distance_bound;
  const float involution = bounds.involution_bound;
  const float at_bounds = of(turn, average, involution);
  EXPECT_LT(of(0.5F * turn, average, involution), at_bounds);
  EXPECT_LT(of(turn, 0.5F * average, involution), at_bounds);
  EXPECT_LT(of(turn, average, 0.5F * involution), at_bounds);
  EXPECT_EQ(of(turn, 3.0F * average, 3.0F * involution), at_bounds);
  EXPECT_LT(of(2.0F * turn, average, involution), at_bounds) << "normals that fit worse than in any right map";
}

TEST(MapConfidence, FallsWithWhatStandsStillBeyondAHeadATailAndASeam)
{
  MapEvidence evidence = evidenceOfRightMap();
  const auto at = [&](float fixed) {
    evidence.score.fixed = fixed;
    return mapConfidence(evidence);
  };
  EXPECT_EQ(at(0.05F), at(0.2F));
  EXPECT_LT(at(0.25F), at(0.2F));
  EXPECT_LT(at(0.35F), at(0.25F));
  EXPECT_EQ(at(0.35F), at(0.6F));
}

TEST(MapConfidence, FallsWhereMuchOfTheSurfaceIsDistorted)
{
  MapEvidence evidence = evidenceOfRightMap();
  const auto at = [&](float distorted) {
    evidence.score.distorted = distorted;
    return mapConfidence(evidence);
  };
  EXPECT_EQ(at(0.2F), at(0.0F));
  EXPECT_LT(at(0.3F), at(0.2F));
  EXPECT_LT(at(0.5F), at(0.3F));
}

/** A four-legged body in a sparse cloud, mapped front to back: what a pose explains must not excuse all of it. */
TEST(MapConfidence, RefusesAMapFromHeadToTail)
{
  MapEvidence evidence;
  evidence.score.distorted = 0.447F;
  evidence.score.fixed = 0.018F;
  evidence.rough_curvature = 0.6F;
  evidence.measures.stretch = 0.238F;
  evidence.measures.involution = 0.0746F;
  evidence.measures.average_distance = 0.0865F;
  evidence.fit = {0.0186F, 0.2F};
  evidence.worst_distance = 0.0649F;
  evidence.at_holes = 0.206F;
  evidence.spacing = {0.0126F, 1.72F};
  EXPECT_LT(mapConfidence(evidence), RefusalCalibration{}.one_interpretation);
}

TEST(MapConfidence, DoubtsStretchInOnePlaceMoreThanStretchEverywhere)
{
  MapEvidence evidence = evidenceOfRightMap();
  evidence.measures.stretch *= 2.0F;
  const float in_one_place = mapConfidence(evidence);
  evidence.measures.average_distance *= 2.0F;
  evidence.measures.involution *= 2.0F;
  evidence.fit.turn *= 1.5F;
  EXPECT_GT(mapConfidence(evidence), in_one_place);
}

TEST(MapConfidence, AllowsForPointsThatAreFarApart)
{
  MapEvidence evidence = evidenceOfRightMap();
  evidence.fit.distance *= 3.0F;
  const auto at = [&](float sparse, float irregularity) {
    evidence.spacing = {sparse, irregularity};
    return mapConfidence(evidence);
  };
  EXPECT_EQ(at(0.01F, 2.3F), at(0.0F, 2.3F)) << "dense enough";
  EXPECT_GT(at(0.015F, 2.3F), at(0.01F, 2.3F));
  EXPECT_GT(at(0.02F, 2.3F), at(0.015F, 2.3F));
  EXPECT_LT(at(0.02F, 1.6F), at(0.02F, 2.3F)) << "evenly spread points leave smaller gaps";
  EXPECT_EQ(at(0.02F, 1.3F), at(0.01F, 1.3F));
}

TEST(MeasureSpacing, HasTheSparseSamplesAndTheUsualIrregularity)
{
  // A path of 20 vertices with growing steps, and a vertex without edges.
  std::vector<GraphEdge> edges;
  for (Index v = 0; v + 1 < 20; ++v) {
    edges.push_back({v, v + 1, static_cast<float>(v + 1)});
  }
  const SurfaceGraph graph = buildGraph(21, edges);
  std::vector<Index> samples(21);
  std::iota(samples.begin(), samples.end(), 0);
  // Vertex v > 0 lies between edges of the lengths v and v + 1; vertex 18 is the 19th of the 20 that have edges.
  const PointSpacing all = measureSpacing(graph, samples, 2.0F);
  EXPECT_FLOAT_EQ(all.sparse, 18.5F / 2.0F);
  // Both ends have one edge each, the others (v + 0.5) / v: the 11th of them, from below, is that of vertex 10.
  EXPECT_FLOAT_EQ(all.irregularity, 10.5F / 10.0F);
  const PointSpacing one = measureSpacing(graph, {5}, 1.0F);
  EXPECT_FLOAT_EQ(one.sparse, 5.5F);
  EXPECT_FLOAT_EQ(one.irregularity, 1.1F);
  EXPECT_EQ(measureSpacing(graph, {20}, 1.0F).sparse, 0.0F);
  const SurfaceGraph at_one_place = buildGraph(2, {{0, 1, 0.0F}});
  EXPECT_EQ(measureSpacing(at_one_place, {0, 1}, 1.0F).irregularity, 1.0F);
}

TEST(BestTrustedMap, IsTheFirstThatIsNotRefused)
{
  using Choice = std::pair<std::size_t, float>;
  EXPECT_EQ(bestTrustedMap({{-4.0F, 0.5F}, {-4.0F, 0.9F}}, 0.35F), Choice(0, 0.5F));
  EXPECT_EQ(bestTrustedMap({{-4.0F, 0.1F}, {-4.0F, 0.2F}, {-4.0F, 0.6F}, {-4.0F, 0.9F}}, 0.35F), Choice(2, 0.6F));
  EXPECT_EQ(bestTrustedMap({{-4.0F, 0.1F}, {-4.0F, 0.3F}}, 0.35F), Choice(0, 0.1F)) << "all refused";
}

TEST(BestTrustedMap, TrustsLessWhatFitsWorse)
{
  const float half_more_misfit = std::log(1.5F);
  const auto [number, confidence] = bestTrustedMap({{-4.0F, 0.1F}, {-4.0F + half_more_misfit, 0.9F}}, 0.35F);
  EXPECT_EQ(number, 1U);
  EXPECT_NEAR(confidence, 0.4F, 1e-5F);
  EXPECT_EQ(bestTrustedMap({{-4.0F, 0.1F}, {-4.0F + half_more_misfit, 0.7F}}, 0.35F).first, 0U) << "refused as well";
}

TEST(MapConfidence, IsBounded)
{
  for (const float extreme : {0.0F, 1.0F, 1e6F}) {
    MapEvidence evidence;
    evidence.measures.stretch = extreme;
    evidence.measures.average_distance = extreme;
    evidence.fit = {extreme, extreme};
    evidence.worst_distance = extreme;
    evidence.rough_curvature = extreme;
    const float confidence = mapConfidence(evidence);
    EXPECT_TRUE(confidence >= 0.0F && confidence <= 1.0F) << extreme;
  }
}

} // namespace
