#include "symmetry/names/even_functions.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** Of the matrix of a map: functions that it keeps have 1, those that it turns over -1. Between them, away from zero. */
constexpr double least_kept = 0.3;

Eigen::MatrixXd
carried(const Eigen::MatrixXd& functions, const SampleMap& map)
{
  Eigen::MatrixXd images(functions.rows(), functions.cols());
  for (std::size_t i = 0; i < map.size(); ++i) {
    images.row(static_cast<Eigen::Index>(i)) = functions.row(map[i]);
  }
  return images;
}

/** The eigenvectors of a symmetric matrix whose eigenvalues are not below a limit. */
Eigen::MatrixXd
upperEigenvectors(const Eigen::MatrixXd& matrix, double least)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const Eigen::Index below = (solver.eigenvalues().array() < least).count(); // they rise
  return solver.eigenvectors().rightCols(matrix.cols() - below);
}

} // namespace

EvenFunctions
evenFunctions(const LaplacianBasis& basis, const SampleMap& map)
{
  const Eigen::MatrixXd functions = basis.functions.cast<double>();
  const Eigen::VectorXd masses = basis.masses.cast<double>();
  const Eigen::MatrixXd matrix = functions.transpose() * masses.asDiagonal() * carried(functions, map);
  const Eigen::MatrixXd kept = upperEigenvectors(0.5 * (matrix + matrix.transpose()), least_kept);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> within(kept.transpose() *
                                                              basis.eigenvalues.cast<double>().asDiagonal() * kept);
  EvenFunctions even;
  const Eigen::Index count = std::max<Eigen::Index>(0, kept.cols() - 1); // the first one is constant
  const Eigen::MatrixXd raw = functions * (kept * within.eigenvectors().rightCols(count));
  even.functions = 0.5 * (raw + carried(raw, map));
  even.eigenvalues = within.eigenvalues().tail(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double square = masses.dot(even.functions.col(k).cwiseAbs2()) / masses.sum();
    even.functions.col(k) /= std::sqrt(std::max(square, least_kept));
  }
  return even;
}

} // namespace symmetry
} // namespace pcl
