#include "symmetry/search/functional_map.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <random>

using namespace pcl::symmetry;

namespace {

Eigen::MatrixXf
randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937 random(seed);
  Eigen::MatrixXf matrix(rows, columns);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix.data()[i] = static_cast<float>(random() % 20001U) / 10000.0F - 1.0F;
  }
  return matrix;
}

TEST(NearestRows, AreThoseOfBruteForce)
{
  const Eigen::MatrixXf targets = randomMatrix(200, 7, 1);
  const Eigen::MatrixXf queries = randomMatrix(90, 7, 2);
  const SampleMap nearest = nearestRows(queries, targets);
  ASSERT_EQ(nearest.size(), 90U);
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    Eigen::Index expected = 0;
    (targets.rowwise() - queries.row(i)).rowwise().squaredNorm().minCoeff(&expected);
    EXPECT_EQ(nearest[static_cast<std::size_t>(i)], expected);
  }
}

TEST(NearestRows, TiesGoToTheLowest)
{
  Eigen::MatrixXf targets(4, 2);
  targets << 5, 5, 1, 0, 1, 0, 0, 1;
  Eigen::MatrixXf query(1, 2);
  query << 0.5F, 0.5F;
  EXPECT_EQ(nearestRows(query, targets), SampleMap{1});
}

TEST(NearestInvolution, IsSymmetricAndItsOwnInverse)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Eigen::MatrixXf involution = nearestInvolution(randomMatrix(9, 9, seed));
    EXPECT_LT((involution - involution.transpose()).norm(), 1e-5F);
    EXPECT_LT((involution * involution - Eigen::MatrixXf::Identity(9, 9)).norm(), 1e-5F);
    const Eigen::VectorXf eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf>(involution).eigenvalues();
    EXPECT_LT((eigenvalues.cwiseAbs().array() - 1.0F).abs().maxCoeff(), 1e-5F);
  }
}

TEST(NearestInvolution, LeavesAnInvolutionAsItIs)
{
  const Eigen::MatrixXf involution = nearestInvolution(randomMatrix(9, 9, 4));
  EXPECT_LT((nearestInvolution(involution) - involution).norm(), 1e-5F);
}

TEST(NearestInvolution, NoneIsNearer)
{
  const Eigen::MatrixXf matrix = randomMatrix(5, 5, 5);
  const float nearest = (nearestInvolution(matrix) - matrix).norm();
  for (unsigned seed = 10; seed < 200; ++seed) {
    EXPECT_GE((nearestInvolution(randomMatrix(5, 5, seed)) - matrix).norm(), nearest);
  }
}

} // namespace
