#include "symmetry/search/functional_map.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace pcl {
namespace symmetry {

namespace {

/** Row i of the result is row rows[i] of the matrix. */
Eigen::MatrixXf
rowsOf(const Eigen::MatrixXf& matrix, const SampleMap& rows)
{
  Eigen::MatrixXf picked(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    const float* from = matrix.col(column).data();
    float* to = picked.col(column).data();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      to[i] = from[rows[i]];
    }
  }
  return picked;
}

} // namespace

SampleMap
nearestRows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& targets)
{
  return RowSearch(targets).nearest(queries);
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
    level.search = RowSearch(level.functions);
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
    Eigen::MatrixXf targets(samples, level.functions.cols() + local_parts.cols());
    targets << level.functions, level.weight * local_parts;
    level.search = RowSearch(targets);
  }
}

SampleMap
UpwardRefinement::match(const Level& level, const Eigen::MatrixXf& matrix) const
{
  const Eigen::MatrixXf images = level.functions * matrix;
  if (descriptor_ == nullptr) {
    return level.search.nearest(images);
  }
  // Row and column 0 belong to the constant function.
  const Eigen::Index d = matrix.cols() - 1;
  const Eigen::MatrixXf local_parts =
      descriptor_->mirroredLocalParts(matrix.bottomRightCorner(d, d), level.functions.rows());
  Eigen::MatrixXf queries(images.rows(), images.cols() + local_parts.cols());
  queries << images, level.weight * local_parts;
  return level.search.nearest(queries);
}

Eigen::MatrixXf
UpwardRefinement::refine(SampleMap& map) const
{
  Eigen::MatrixXf matrix;
  for (const Level& level : levels_) {
    matrix = nearestInvolution(level.pseudo_inverse * rowsOf(level.functions, map));
    map = match(level, matrix);
  }
  return matrix;
}

} // namespace symmetry
} // namespace pcl
