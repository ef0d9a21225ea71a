#include "support/human.h"
#include "symmetry/sides/intrinsic_functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

TEST(IntrinsicFunctions, AreBroughtToMeanZeroAndMeanSquareOne)
{
  const CoarseSurface& coarse = human().coarse;
  Eigen::VectorXd function(static_cast<Eigen::Index>(coarse.size()));
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    function(static_cast<Eigen::Index>(i)) = 5.0 + 3.0 * static_cast<double>(coarse.points[i][1]);
  }
  const Eigen::VectorXd scaled = standardized(function, coarse);
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const double value = scaled(static_cast<Eigen::Index>(i));
    mean += static_cast<double>(coarse.areas[i]) * value;
    square += static_cast<double>(coarse.areas[i]) * value * value;
  }
  EXPECT_NEAR(mean, 0.0, 1e-5);
  EXPECT_NEAR(square, 1.0, 1e-5);
  EXPECT_TRUE(standardized(Eigen::VectorXd::Constant(function.size(), 7.0), coarse).isZero());
}

TEST(IntrinsicFunctions, HeatIsTheSumOverEigenfunctions)
{
  LaplacianBasis basis;
  basis.functions = Eigen::MatrixXf(2, 3);
  basis.functions << 1.0F, 2.0F, 0.0F, 1.0F, 0.0F, 3.0F;
  basis.eigenvalues = Eigen::VectorXf(3);
  basis.eigenvalues << 0.0F, 10.0F, 20.0F;
  const Eigen::VectorXd heat = heatSignature(basis, 0.1);
  EXPECT_NEAR(heat(0), std::log(std::exp(-1.0) * 4.0), 1e-6); // the constant function says nothing
  EXPECT_NEAR(heat(1), std::log(std::exp(-2.0) * 9.0), 1e-6);
}

TEST(IntrinsicFunctions, OutwardsAndTurnsFollowTheNormals)
{
  CoarseSurface coarse = human().coarse;
  EXPECT_EQ(outwards(coarse), 1.0);
  const Triangle triangle = coarse.triangles.front();
  const double turn = turnOf(triangle, coarse);
  EXPECT_EQ(turnOf({triangle[0], triangle[2], triangle[1]}, coarse), -turn);
  for (Vector3& normal : coarse.normals) {
    normal = -1.0F * normal;
  }
  EXPECT_EQ(outwards(coarse), -1.0);
  EXPECT_EQ(turnOf(triangle, coarse), -turn);
}

} // namespace
