#include "support/coarse_body.h"
#include "support/with_threads.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/search/functional_map.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(CellMembers, AreThePointsOfEachCell)
{
  const CoarseBody body = coarseBody(Body::Bird, 1.0);
  const CellMembers members = membersOfCells(body.coarse);
  ASSERT_EQ(members.offsets.size(), body.coarse.size() + 1);
  ASSERT_EQ(members.points.size(), body.surface.size());
  for (std::size_t cell = 0; cell < body.coarse.size(); ++cell) {
    EXPECT_LT(members.offsets[cell], members.offsets[cell + 1]); // the sample at least
    for (std::uint32_t e = members.offsets[cell]; e < members.offsets[cell + 1]; ++e) {
      EXPECT_EQ(body.coarse.cells.owner[members.points[e]], static_cast<Index>(cell));
      EXPECT_TRUE(e == members.offsets[cell] || members.points[e] > members.points[e - 1]);
    }
  }
}

TEST(PartnersOfPoints, FollowTheTruePartnersOfTheSamples)
{
  const CoarseBody body = coarseBody(Body::Human, 1.0);
  std::vector<Index> of_samples;
  for (const Index v : body.coarse.cells.vertices) {
    of_samples.push_back(body.model.partners[v]);
  }
  const std::vector<Index> one = partnersOfPoints(body.sampled(), of_samples);
  const std::vector<double> errors = mapErrors(body.model, one);
  EXPECT_EQ(correspondenceRate(errors), 1.0);
  EXPECT_LT(mean(errors), 0.01); // a third of the spacing of the samples
  EXPECT_EQ(one, withThreads(5, [&] { return partnersOfPoints(body.sampled(), of_samples); }));
}

TEST(PartnersOfSamples, LieWithinASpacingOfTheTruth)
{
  const CoarseBody body = coarseBody(Body::Human, 0.0);
  SampleMap map;
  for (const Index v : body.coarse.cells.vertices) {
    map.push_back(body.coarse.cells.owner[body.model.partners[v]]);
  }
  // The map's action on 30 eigenfunctions, by least squares.
  const Eigen::MatrixXf functions = body.basis.functions.leftCols(30);
  Eigen::MatrixXf images(functions.rows(), functions.cols());
  for (Eigen::Index i = 0; i < images.rows(); ++i) {
    images.row(i) = functions.row(map[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXf matrix = nearestInvolution(functions.transpose() * body.basis.masses.asDiagonal() * images);
  const std::vector<Index> partners = partnersOfSamples(body.sampled(), map, matrix);
  ASSERT_EQ(partners.size(), body.coarse.size());
  double error = 0.0;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const Index truth = body.model.partners[body.coarse.cells.vertices[i]];
    error += distance(body.surface.points[partners[i]], body.surface.points[truth]);
  }
  const std::vector<float>& lengths = body.coarse.graph.lengths;
  const double spacing = std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
  EXPECT_LT(error / static_cast<double>(partners.size()), 0.5 * spacing);
}

} // namespace
