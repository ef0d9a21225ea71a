#include "symmetry/refine/map_misfit.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {

float
logMisfit(const std::vector<PatchFit>& fits, const PatchFit& mean, float weight_of_median)
{
  constexpr float least_distance = 2e-3F;     // sampling noise
  constexpr float least_turn = 0.01F;         // the same: 8 degrees
  constexpr float least_median_turn = 0.005F; // as MapCalibration::turn_floor: 6 degrees; not fitted
  std::vector<float> turns(fits.size());
  std::transform(fits.begin(), fits.end(), turns.begin(), [](const PatchFit& fit) { return fit.turn; });
  return 0.5F * std::log(mean.distance + least_distance) + std::log(mean.turn + least_turn) +
         weight_of_median * std::log(median(std::move(turns)) + least_median_turn);
}

} // namespace symmetry
} // namespace pcl
