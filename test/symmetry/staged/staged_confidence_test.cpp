#include "support/graphs.h"
#include "symmetry/staged/staged_confidence.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** A chain of eleven vertices, one apart, in space as in the graph. */
struct Chain {
  SurfaceGraph graph;
  std::vector<Vector3> points;
};

Chain
chain()
{
  Chain chain;
  std::vector<GraphEdge> edges;
  for (Index v = 0; v < 11; ++v) {
    chain.points.push_back({static_cast<float>(v), 0.0F, 0.0F});
    if (v > 0) {
      edges.push_back({v - 1, v, 1.0F});
    }
  }
  chain.graph = buildGraph(11, edges);
  return chain;
}

float
distortion(std::vector<SymmetricMatch> matches)
{
  const Chain line = chain();
  const GeodesicMetric metric(line.graph);
  BaseVertices base(metric);
  base.addPairs(matches);
  return isometricDistortion(base, matches, 10.0F);
}

} // namespace

TEST(IsometricDistortion, IsZeroForAMirror)
{
  EXPECT_EQ(distortion({{0, 10, 0, 0.0F}, {3, 7, 0, 0.0F}, {4, 6, 0, 0.0F}}), 0.0F);
}

TEST(IsometricDistortion, IsTheMeanChangeOfDistances)
{
  // Between the pairs (0, 10) and (3, 8): |3 - 2| twice and |8 - 7| twice, of eight terms; a tenth is the diameter.
  EXPECT_FLOAT_EQ(distortion({{0, 10, 0, 0.0F}, {3, 8, 0, 0.0F}}), 4.0F / 8.0F / 10.0F);
  EXPECT_EQ(distortion({}), 0.0F);
}

TEST(InvolutionShare, CountsVerticesThatComeBack)
{
  const Chain line = chain();
  std::vector<Index> partners = {10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  EXPECT_EQ(involutionShare(line.points, partners, 10.0F), 1.0F);
  partners[0] = 9; // 0 -> 9 -> 1, and 10 -> 0 -> 9
  EXPECT_FLOAT_EQ(involutionShare(line.points, partners, 10.0F), 9.0F / 11.0F);
  partners[3] = no_index; // and so the partner of 7 has none
  EXPECT_FLOAT_EQ(involutionShare(line.points, partners, 10.0F), 7.0F / 9.0F);
  EXPECT_EQ(involutionShare(line.points, std::vector<Index>(11, no_index), 10.0F), 0.0F);
}

TEST(DistortionConfidence, FallsWithTheDistortion)
{
  EXPECT_EQ(distortionConfidence(0.0F), 1.0F);
  EXPECT_NEAR(distortionConfidence(0.05F), std::exp(-1.0F), 1e-6F);
  EXPECT_GT(distortionConfidence(0.04F), minimum_trusted_confidence);
  EXPECT_LT(distortionConfidence(0.1F), minimum_trusted_confidence);
}

TEST(VertexConfidences, RankExactMatchesFirst)
{
  const Chain line = chain();
  DenseMap map;
  map.partners = {10, 9, 8, 7, 6, 5, 4, 3, 2, 1, no_index};
  map.dissimilarities.assign(11, 0.0F);
  map.dissimilarities[2] = 0.4F;
  map.partners[3] = 8; // 3 -> 8 -> 2
  const std::vector<float> confidences = vertexConfidences(line.points, map, 10, 10.0F, 0.9F);
  EXPECT_EQ(confidences[0], 0.0F); // its partner has none
  EXPECT_EQ(confidences[10], 0.0F);
  EXPECT_FLOAT_EQ(confidences[1], 0.9F);
  EXPECT_FLOAT_EQ(confidences[2], 0.9F * std::exp(-0.2F / 0.15F));
  EXPECT_FLOAT_EQ(confidences[3], 0.9F * std::exp(-1.0F));
}
