#include "support/named_body.h"
#include "symmetry/names/even_functions.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const EvenFunctions&
humanFunctions()
{
  static const EvenFunctions even = evenFunctions(human().basis, trueSampleMap(human()));
  return even;
}

TEST(EvenFunctions, AreAboutHalfOfAllAndHaveTheSameValueAtPartners)
{
  const EvenFunctions& even = humanFunctions();
  const SampleMap map = trueSampleMap(human());
  EXPECT_GT(even.functions.cols(), 15); // of 39 that are not constant
  EXPECT_LT(even.functions.cols(), 25);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[static_cast<std::size_t>(map[i])] == static_cast<Index>(i)) {
      EXPECT_NEAR((even.functions.row(static_cast<Eigen::Index>(i)) - even.functions.row(map[i])).norm(), 0.0, 1e-9);
    }
  }
}

TEST(EvenFunctions, AreOrthonormalAndRise)
{
  const EvenFunctions& even = humanFunctions();
  const Eigen::MatrixXd gram =
      even.functions.transpose() * human().basis.masses.cast<double>().asDiagonal() * even.functions;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).leftCols(8).cwiseAbs().maxCoeff(), 0.15);
  EXPECT_GT(even.eigenvalues(0), 0.0);
  for (Eigen::Index k = 1; k < even.eigenvalues.size(); ++k) {
    EXPECT_LE(even.eigenvalues(k - 1), even.eigenvalues(k));
  }
}

TEST(EvenFunctions, AreAllWhereNothingMoves)
{
  SampleMap identity;
  for (std::size_t i = 0; i < human().coarse.size(); ++i) {
    identity.push_back(static_cast<Index>(i));
  }
  const EvenFunctions even = evenFunctions(human().basis, identity);
  ASSERT_EQ(even.functions.cols(), human().basis.functions.cols() - 1);
  EXPECT_NEAR(even.eigenvalues(0), static_cast<double>(human().basis.eigenvalues(1)), 1e-3);
}

} // namespace
