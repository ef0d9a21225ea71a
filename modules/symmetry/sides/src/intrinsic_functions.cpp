#include "symmetry/sides/intrinsic_functions.h"

#include "base/vector_math.h"

#include <cmath>

namespace pcl {
namespace symmetry {

Eigen::VectorXd
standardized(Eigen::VectorXd function, const CoarseSurface& coarse)
{
  constexpr double constant = 1e-6; // deviation below which a function is constant
  const Eigen::VectorXd areas =
      Eigen::Map<const Eigen::VectorXf>(coarse.areas.data(), static_cast<Eigen::Index>(coarse.areas.size()))
          .cast<double>();
  function.array() -= areas.dot(function) / areas.sum();
  const double deviation = std::sqrt(areas.dot(function.cwiseAbs2()) / areas.sum());
  return deviation > constant ? Eigen::VectorXd(function / deviation) : Eigen::VectorXd::Zero(function.size());
}

Eigen::VectorXd
heatSignature(const LaplacianBasis& basis, double time)
{
  constexpr double least_heat = 1e-12; // whose logarithm is taken
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(basis.functions.rows());
  for (Eigen::Index k = 1; k < basis.functions.cols(); ++k) {
    heat +=
        std::exp(-time * static_cast<double>(basis.eigenvalues(k))) * basis.functions.col(k).cast<double>().cwiseAbs2();
  }
  return heat.cwiseMax(least_heat).array().log().matrix();
}

double
outwards(const CoarseSurface& coarse)
{
  Vector3 middle{};
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    middle = middle + coarse.areas[i] * coarse.points[i];
  }
  double volume = 0.0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    volume += coarse.areas[i] * dot(coarse.points[i] - middle, coarse.normals[i]);
  }
  return volume < 0.0 ? -1.0 : 1.0;
}

double
turnOf(const Triangle& triangle, const CoarseSurface& coarse)
{
  const auto& [a, b, c] = triangle;
  const Vector3 facing = cross(coarse.points[b] - coarse.points[a], coarse.points[c] - coarse.points[a]);
  const Vector3 normal = coarse.normals[a] + coarse.normals[b] + coarse.normals[c];
  return dot(facing, normal) < 0.0F ? -1.0 : 1.0;
}

} // namespace symmetry
} // namespace pcl
