#include "symmetry/map_asymmetry.h"

#include "symmetry/map_repair.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr float tiny = 1e-3F;

float
quantile(std::vector<float> values, double share)
{
  if (values.empty()) {
    return 0.0F;
  }
  const auto rank = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** Mean |d (i, j) - d (m (i), m (j))| over every other hub j, for each hub i; share of the diameter. */
std::vector<float>
distanceChanges(const HubSurface& hubs, const SampleMap& map)
{
  constexpr std::size_t step = 2;
  std::vector<float> changes(hubs.size());
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    const float* from = hubs.distances.col(static_cast<Eigen::Index>(i)).data();
    const float* to = hubs.distances.col(map[i]).data();
    float sum = 0.0F;
    std::size_t count = 0;
    for (std::size_t j = 0; j < hubs.size(); j += step, ++count) {
      sum += std::abs(from[j] - to[map[j]]);
    }
    changes[i] = sum / (static_cast<float>(count) * hubs.diameter);
  }
  return changes;
}

std::vector<float>
returnErrors(const HubSurface& hubs, const SampleMap& map)
{
  std::vector<float> errors(hubs.size());
  for (std::size_t i = 0; i < hubs.size(); ++i) {
    errors[i] = hubs.distances(static_cast<Eigen::Index>(i), map[static_cast<std::size_t>(map[i])]) / hubs.diameter;
  }
  return errors;
}

} // namespace

AsymmetrySigns
findAsymmetry(const HubSurface& hubs, const SampleMap& map)
{
  constexpr double worst = 0.99;
  AsymmetrySigns signs;
  const std::vector<float> stretch = stretchAtHubs(hubs, map);
  signs.concentration = (quantile(stretch, worst) + tiny) / (quantile(stretch, 0.5) + tiny);
  const SampleMap healed = relaxedMap(hubs, map);
  signs.change = quantile(distanceChanges(hubs, healed), worst);
  signs.involution = quantile(returnErrors(hubs, healed), worst);
  return signs;
}

float
asymmetry(const AsymmetrySigns& signs, float curvature)
{
  return std::log(signs.concentration) + std::log(signs.change + tiny) + 2.0F * std::log(signs.involution + tiny) +
         1.5F * std::log(curvature + tiny);
}

} // namespace symmetry
} // namespace pcl
