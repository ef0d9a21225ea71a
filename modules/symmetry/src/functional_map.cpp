#include "symmetry/functional_map.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace pcl {
namespace symmetry {

SampleMap
nearestRows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& targets)
{
  const Eigen::VectorXf half_norms = 0.5F * targets.rowwise().squaredNorm();
  const Eigen::MatrixXf products = targets * queries.transpose();
  SampleMap nearest(static_cast<std::size_t>(queries.rows()));
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    Eigen::Index best = 0;
    (half_norms - products.col(i)).minCoeff(&best);
    nearest[static_cast<std::size_t>(i)] = static_cast<Index>(best);
  }
  return nearest;
}

Eigen::MatrixXf
nearestInvolution(const Eigen::MatrixXf& matrix)
{
  const Eigen::MatrixXf symmetric = 0.5F * (matrix + matrix.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(symmetric);
  const Eigen::VectorXf signs = solver.eigenvalues().unaryExpr([](float x) { return x < 0.0F ? -1.0F : 1.0F; });
  return solver.eigenvectors() * signs.asDiagonal() * solver.eigenvectors().transpose();
}

UpwardRefinement::UpwardRefinement(const Eigen::MatrixXf& functions,
                                   Eigen::Index samples,
                                   const std::vector<int>& dimensions)
{
  for (const int d : dimensions) {
    Level level;
    level.functions = functions.topLeftCorner(samples, std::min<Eigen::Index>(d, functions.cols()));
    const Eigen::MatrixXf gram = level.functions.transpose() * level.functions;
    level.pseudo_inverse = gram.ldlt().solve(level.functions.transpose());
    levels_.push_back(std::move(level));
  }
}

UpwardRefinement::UpwardRefinement(const Eigen::MatrixXf& functions,
                                   const ShapeDescriptor& descriptor,
                                   Eigen::Index samples,
                                   const std::vector<int>& dimensions,
                                   float guidance)
    : UpwardRefinement(functions, samples, dimensions)
{
  descriptor_ = &descriptor;
  const Eigen::MatrixXf local_parts = descriptor.localParts(samples);
  for (Level& level : levels_) {
    // The eigenfunctions have unit variance each: their sum grows with their number.
    level.weight = guidance * std::sqrt(static_cast<float>(level.functions.cols()));
    level.targets.resize(samples, level.functions.cols() + local_parts.cols());
    level.targets << level.functions, level.weight * local_parts;
  }
}

SampleMap
UpwardRefinement::match(const Level& level, const Eigen::MatrixXf& matrix) const
{
  if (descriptor_ == nullptr) {
    return nearestRows(level.functions * matrix, level.functions);
  }
  // Row and column 0 belong to the constant function.
  const Eigen::Index d = matrix.cols() - 1;
  Eigen::MatrixXf queries(level.targets.rows(), level.targets.cols());
  queries << level.functions * matrix,
      level.weight * descriptor_->mirroredLocalParts(matrix.bottomRightCorner(d, d), level.targets.rows());
  return nearestRows(queries, level.targets);
}

Eigen::MatrixXf
UpwardRefinement::refine(SampleMap& map) const
{
  Eigen::MatrixXf matrix;
  for (const Level& level : levels_) {
    Eigen::MatrixXf pulled_back(level.functions.rows(), level.functions.cols());
    for (Eigen::Index i = 0; i < pulled_back.rows(); ++i) {
      pulled_back.row(i) = level.functions.row(map[static_cast<std::size_t>(i)]);
    }
    matrix = nearestInvolution(level.pseudo_inverse * pulled_back);
    map = match(level, matrix);
  }
  return matrix;
}

} // namespace symmetry
} // namespace pcl
