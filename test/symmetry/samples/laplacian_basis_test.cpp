#include "support/coarse_body.h"
#include "symmetry/samples/laplacian_basis.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(LaplacianBasis, HasTheEigenvaluesOfASphere)
{
  // l (l + 1) on the unit sphere, 2 l + 1 times each. Cells share an area of 1, conductances do not depend on the
  // scale: 4 pi l (l + 1). The ways between samples are up to a sixth longer than straight lines.
  const PreparedSurface sphere = preparedMesh(sphereMesh(6));
  const LaplacianBasis basis = laplacianBasis(coarsenSurface(sphere, 1500), 25);
  ASSERT_EQ(basis.eigenvalues.size(), 25);
  const double full_turn = 4.0 * std::acos(-1.0);
  Eigen::Index a = 0;
  for (int l = 0; l < 5; ++l) {
    const double expected = full_turn * l * (l + 1);
    for (int m = 0; m < 2 * l + 1; ++m, ++a) {
      EXPECT_GE(basis.eigenvalues(a), 0.82 * expected - 1e-3) << "l = " << l;
      EXPECT_LE(basis.eigenvalues(a), 1.02 * expected + 1e-3) << "l = " << l;
    }
  }
}

TEST(LaplacianBasis, FunctionsAreOrthonormalUnderTheMasses)
{
  const CoarseBody human = coarseBody(Body::Human, 1.0);
  const Eigen::MatrixXf gram =
      human.basis.functions.transpose() * human.basis.masses.asDiagonal() * human.basis.functions;
  EXPECT_LT((gram - Eigen::MatrixXf::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-3F);
  EXPECT_NEAR(human.basis.masses.sum(), 1.0F, 1e-3F);
}

TEST(LaplacianBasis, TheFirstFunctionIsConstantAndEigenvaluesRise)
{
  const LaplacianBasis basis = coarseBody(Body::Quadruped, 1.0).basis;
  const Eigen::VectorXf first = basis.functions.col(0);
  EXPECT_LT((first.array() - first.mean()).abs().maxCoeff(), 1e-3F);
  EXPECT_NEAR(basis.eigenvalues(0), 0.0F, 1e-3F);
  EXPECT_GT(basis.eigenvalues(1), 1e-2F); // connected
  for (Eigen::Index a = 1; a < basis.eigenvalues.size(); ++a) {
    EXPECT_GE(basis.eigenvalues(a), basis.eigenvalues(a - 1));
  }
}

TEST(LaplacianBasis, EigenvaluesBarelyChangeWithThePose)
{
  const LaplacianBasis rest = coarseBody(Body::Bird, 0.0).basis;
  const LaplacianBasis posed = coarseBody(Body::Bird, 1.0).basis;
  for (Eigen::Index a = 1; a < 12; ++a) {
    EXPECT_NEAR(posed.eigenvalues(a), rest.eigenvalues(a), 0.1F * rest.eigenvalues(a)) << a;
  }
}

} // namespace
