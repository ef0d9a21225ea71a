#include "symmetry/confidence/local_change.h"

#include "base/parallel.h"
#include "base/statistics.h"

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** Column j: distances from every landmark to the partner of landmark j. */
Eigen::MatrixXf
distancesToPartners(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  const Eigen::MatrixXf& to_samples = sampled.landmarks.to_samples;
  const SampleInterpolation& interpolation = sampled.interpolation;
  Eigen::MatrixXf result(to_samples.cols(), to_samples.cols());
  parallelFor(
      static_cast<std::size_t>(result.cols()),
      [&](std::size_t j) {
        const Index point = partners[j];
        auto column = result.col(static_cast<Eigen::Index>(j));
        column.setZero();
        for (std::uint32_t e = interpolation.offsets[point]; e < interpolation.offsets[point + 1]; ++e) {
          column += interpolation.weights[e] * to_samples.row(interpolation.samples[e]).transpose();
        }
      },
      32);
  return result;
}

} // namespace

std::vector<float>
localDistanceChange(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  constexpr float nearest = 0.05F;
  constexpr float farthest = 0.25F;
  constexpr double percentile = 0.8;
  const Eigen::MatrixXf to_partners = distancesToPartners(sampled, partners);
  const float diameter = sampled.landmarks.diameter;
  std::vector<float> change(static_cast<std::size_t>(to_partners.cols()), 0.0F);
  parallelFor(
      change.size(),
      [&](std::size_t k) {
        const auto i = static_cast<Eigen::Index>(k);
        std::vector<float> changes;
        for (Eigen::Index j = 0; j < to_partners.cols(); ++j) {
          const float length = to_partners(j, i); // from landmark j to the partner of i
          if (length >= nearest * diameter && length <= farthest * diameter) {
            changes.push_back(std::abs(length - to_partners(i, j)) / length);
          }
        }
        change[k] = changes.empty() ? 0.0F : quantile(std::move(changes), percentile);
      },
      16);
  return change;
}

} // namespace symmetry
} // namespace pcl
