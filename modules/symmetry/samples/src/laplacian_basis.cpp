#include "symmetry/samples/laplacian_basis.h"

#include "base/heartbeat.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <Spectra/SymEigsShiftSolver.h>
#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/** M^-1/2 L M^-1/2, whose eigenvectors are M^1/2 times the eigenfunctions. */
SparseMatrix
normalizedLaplacian(const CoarseSurface& surface, const Eigen::VectorXd& inverse_root_mass)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    for (std::uint32_t e = surface.graph.offsets[i]; e < surface.graph.offsets[i + 1]; ++e) {
      const Index j = surface.graph.neighbours[e];
      const double weight = surface.conductances[e];
      const double scale = inverse_root_mass(static_cast<Eigen::Index>(i));
      entries.emplace_back(i, j, -weight * scale * inverse_root_mass(j));
      entries.emplace_back(i, i, weight * scale * scale);
    }
  }
  const auto n = static_cast<Eigen::Index>(surface.size());
  SparseMatrix laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/** (A - shift)^-1 as Spectra wants it, for a symmetric A. Spectra's own factorizes by LU, which makes no use of
 * symmetry.
 */
class ShiftedInverse {
public:
  using Scalar = double;

  explicit ShiftedInverse(const SparseMatrix& matrix) : matrix_(matrix)
  {
  }

  Eigen::Index
  rows() const
  {
    return matrix_.rows();
  }

  Eigen::Index
  cols() const
  {
    return matrix_.cols();
  }

  void
  set_shift(double shift)
  {
    factor_.setShift(-shift);
    factor_.compute(matrix_);
  }

  void
  perform_op(const double* from, double* to) const
  {
    heartbeat();
    Eigen::Map<Eigen::VectorXd>(to, rows()) = factor_.solve(Eigen::Map<const Eigen::VectorXd>(from, cols()));
  }

private:
  const SparseMatrix& matrix_;
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
};

} // namespace

LaplacianBasis
laplacianBasis(const CoarseSurface& surface, int count)
{
  LaplacianBasis basis;
  basis.masses = Eigen::Map<const Eigen::VectorXf>(surface.areas.data(), static_cast<Eigen::Index>(surface.size()));
  // A cell without area (a point on no face) still needs some mass.
  const float minimum_mass = 1e-3F / static_cast<float>(surface.size());
  basis.masses = basis.masses.cwiseMax(minimum_mass);
  const Eigen::VectorXd inverse_root_mass = basis.masses.cast<double>().cwiseSqrt().cwiseInverse();
  const SparseMatrix laplacian = normalizedLaplacian(surface, inverse_root_mass);

  ShiftedInverse inverse(laplacian);
  const auto wanted = std::min<Eigen::Index>(count, laplacian.rows() / 2);
  Spectra::SymEigsShiftSolver<ShiftedInverse> solver(inverse, wanted,
                                                     std::min<Eigen::Index>(laplacian.rows(), wanted + 30), -1.0);
  const Eigen::VectorXd start =
      inverse_root_mass.cwiseInverse() + Eigen::VectorXd::LinSpaced(laplacian.rows(), -0.01, 0.01);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 100, 1e-6, Spectra::SortRule::SmallestAlge);
  basis.eigenvalues = solver.eigenvalues().cast<float>();
  basis.functions = (inverse_root_mass.asDiagonal() * solver.eigenvectors()).cast<float>();
  return basis;
}

} // namespace symmetry
} // namespace pcl
