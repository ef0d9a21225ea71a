#include "symmetry/confidence/local_change.h"

#include "base/parallel.h"
#include "base/statistics.h"

#include <cmath>
#include <limits>
#include <utility>

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

/** The changes of the distances between a landmark and the partners at the right distance of those asked for. */
template <typename IsCounted>
std::vector<float>
changesAt(const Eigen::MatrixXf& to_partners, float diameter, Eigen::Index i, IsCounted is_counted)
{
  constexpr float nearest = 0.05F;
  constexpr float farthest = 0.25F;
  std::vector<float> changes;
  for (Eigen::Index j = 0; j < to_partners.cols(); ++j) {
    const float length = to_partners(j, i); // from landmark j to the partner of i
    if (length >= nearest * diameter && length <= farthest * diameter && is_counted(j)) {
      changes.push_back(std::abs(length - to_partners(i, j)) / length);
    }
  }
  return changes;
}

constexpr double percentile = 0.8;

} // namespace

LocalDistanceChange::LocalDistanceChange(const SampledSurface& sampled, const std::vector<Index>& partners)
    : to_partners_(distancesToPartners(sampled, partners)), diameter_(sampled.landmarks.diameter)
{
}

std::vector<float>
LocalDistanceChange::everywhere() const
{
  std::vector<float> change(static_cast<std::size_t>(to_partners_.cols()), 0.0F);
  parallelFor(
      change.size(),
      [&](std::size_t i) {
        std::vector<float> changes =
            changesAt(to_partners_, diameter_, static_cast<Eigen::Index>(i), [](Eigen::Index) { return true; });
        change[i] = changes.empty() ? 0.0F : quantile(std::move(changes), percentile);
      },
      16);
  return change;
}

float
LocalDistanceChange::relativeTo(Index landmark, const std::vector<char>& left_out) const
{
  std::vector<float> changes = changesAt(to_partners_, diameter_, static_cast<Eigen::Index>(landmark),
                                         [&](Eigen::Index j) { return left_out[static_cast<std::size_t>(j)] == 0; });
  return changes.empty() ? std::numeric_limits<float>::infinity() : quantile(std::move(changes), percentile);
}

} // namespace symmetry
} // namespace pcl
