#include "symmetry/sides/side_names.h"

#include "symmetry/sides/intrinsic_functions.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** Integral of (h dg - g dh) ^ du / 2, the triangles turned as the normals say. */
double
enclosedArea(const CoarseSurface& coarse, const Eigen::VectorXd& g, const Eigen::VectorXd& h, const Eigen::VectorXd& u)
{
  double sum = 0.0;
  for (const Triangle& t : coarse.triangles) {
    const auto form = [&](const Eigen::VectorXd& factor, const Eigen::VectorXd& f) {
      const double mean = (factor(t[0]) + factor(t[1]) + factor(t[2])) / 3.0;
      return mean * ((f(t[1]) - f(t[0])) * (u(t[2]) - u(t[0])) - (f(t[2]) - f(t[0])) * (u(t[1]) - u(t[0])));
    };
    sum += 0.5 * turnOf(t, coarse) * (form(h, g) - form(g, h));
  }
  return sum;
}

} // namespace

double
chirality(const SampledSurface& sampled, const std::vector<float>& sides, const SideNameSettings& settings)
{
  const CoarseSurface& coarse = sampled.coarse;
  const auto samples = static_cast<Eigen::Index>(sides.size());
  if (sampled.descriptor.curvature.rows() != samples || sampled.landmarks.to_samples.rows() != samples) {
    return 0.0;
  }
  const double clear = settings.clear;
  const Eigen::VectorXd u =
      Eigen::Map<const Eigen::VectorXf>(sides.data(), samples).cast<double>().cwiseMax(-clear).cwiseMin(clear);
  const Eigen::VectorXd distance = standardized(sampled.landmarks.to_samples.rowwise().mean().cast<double>(), coarse);
  const Eigen::VectorXd coarse_heat = standardized(heatSignature(sampled.basis, settings.long_time), coarse);
  const Eigen::VectorXd fine_heat = standardized(heatSignature(sampled.basis, settings.short_time), coarse);
  const double out = outwards(coarse); // curvature as seen from outside, too
  const Eigen::VectorXd curvature =
      standardized(out * sampled.descriptor.curvature.col(settings.curvature_scale).cast<double>(), coarse);
  return -out * (enclosedArea(coarse, distance, coarse_heat, u) / settings.distance_unit +
                 enclosedArea(coarse, fine_heat, curvature, u) / settings.curvature_unit);
}

} // namespace symmetry
} // namespace pcl
