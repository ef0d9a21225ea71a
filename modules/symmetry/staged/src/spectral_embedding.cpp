#include "symmetry/staged/spectral_embedding.h"

#include "base/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** Squared distances between the landmarks, made exactly symmetric. */
Eigen::MatrixXd
squaredLandmarkDistances(const DistanceFields& fields, const std::vector<Index>& landmarks)
{
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXd squared(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const double d = fields.row(static_cast<std::size_t>(i))[landmarks[static_cast<std::size_t>(j)]];
      squared(i, j) = d * d;
    }
  }
  return 0.5 * (squared + squared.transpose());
}

/** Eigenvectors have no sign of their own: the largest entry is made positive, so that the result is reproducible. */
void
fixSign(Eigen::Ref<Eigen::VectorXd> axis)
{
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis(largest) < 0.0) {
    axis = -axis;
  }
}

} // namespace

SpectralEmbedding
embedByLandmarks(const DistanceFields& fields, const std::vector<Index>& landmarks, int dimensions)
{
  const Eigen::MatrixXd squared = squaredLandmarkDistances(fields, landmarks);
  const Eigen::Index count = squared.rows();
  const Eigen::VectorXd mean = squared.rowwise().mean();
  const Eigen::MatrixXd centring = Eigen::MatrixXd::Identity(count, count) -
                                   Eigen::MatrixXd::Constant(count, count, 1.0 / static_cast<double>(count));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(-0.5 * centring * squared * centring);

  // The solver's eigenvalues rise; the coordinates are taken from the largest down, as long as they are positive.
  const double smallest_used = 1e-9 * std::max(solver.eigenvalues()(count - 1), 0.0);
  SpectralEmbedding embedding;
  while (embedding.dimensions < std::min<Eigen::Index>(dimensions, count) &&
         solver.eigenvalues()(count - 1 - embedding.dimensions) > smallest_used) {
    embedding.eigenvalues.push_back(static_cast<float>(solver.eigenvalues()(count - 1 - embedding.dimensions)));
    ++embedding.dimensions;
  }

  // Row a of the triangulation matrix is v_a / sqrt (lambda_a); a vertex lies at -1/2 of it times (its squared landmark
  // distances - their means).
  Eigen::MatrixXf triangulation(embedding.dimensions, count);
  for (int a = 0; a < embedding.dimensions; ++a) {
    Eigen::VectorXd axis = solver.eigenvectors().col(count - 1 - a);
    fixSign(axis);
    triangulation.row(a) =
        (-0.5 / std::sqrt(double{embedding.eigenvalues[static_cast<std::size_t>(a)]}) * axis).cast<float>();
  }
  const Eigen::VectorXf offset = triangulation * mean.cast<float>();

  embedding.coordinates.resize(fields.columns * static_cast<std::size_t>(embedding.dimensions));
  constexpr std::size_t block = 512;
  parallelBlocks(fields.columns, block, [&] {
    return [&](std::size_t begin, std::size_t end) {
      const auto width = static_cast<Eigen::Index>(end - begin);
      Eigen::MatrixXf distances(count, width);
      for (Eigen::Index i = 0; i < count; ++i) {
        distances.row(i) = Eigen::Map<const Eigen::RowVectorXf>(fields.row(static_cast<std::size_t>(i)) + begin, width)
                               .array()
                               .square();
      }
      Eigen::Map<Eigen::MatrixXf> coordinates(embedding.coordinates.data() +
                                                  begin * static_cast<std::size_t>(embedding.dimensions),
                                              embedding.dimensions, width);
      coordinates.noalias() = triangulation * distances;
      coordinates.colwise() -= offset;
    };
  });
  return embedding;
}

} // namespace symmetry
} // namespace pcl
