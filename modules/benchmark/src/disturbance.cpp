#include "benchmark/disturbance.h"

#include "model/disturb.h"
#include "model/random_numbers.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

void
checkShare(const char* name, double value, double most)
{
  if (value >= 0.0 && value <= most)
    return;
  std::ostringstream message;
  message << name << ' ' << value << " is not in [0, " << most << ']';
  throw pcl::BadArgumentException(message.str());
}

/** Numbers of the points that stay, ascending. */
std::vector<Index>
choosePoints(std::size_t points, double drop, std::uint64_t seed)
{
  std::vector<Index> chosen(points);
  std::iota(chosen.begin(), chosen.end(), Index{0});
  RandomNumbers(seed).shuffle(chosen);
  chosen.resize(points - static_cast<std::size_t>(drop * static_cast<double>(points)));
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

} // namespace

void
checkDisturbance(const Disturbance& disturbance)
{
  checkShare("noise", disturbance.noise, 1.0);
  checkShare("drop", disturbance.drop, 0.99);
  checkShare("outliers", disturbance.outliers, 1.0);
}

DisturbedSurface
disturb(const Surface& surface, const Disturbance& disturbance)
{
  checkDisturbance(disturbance);
  DisturbedSurface disturbed;
  disturbed.origins = choosePoints(surface.size(), disturbance.drop, disturbance.seed);

  Model model{surface, std::vector<Index>(surface.size(), no_index)};
  std::vector<char> keep(surface.size(), 0);
  for (const Index point : disturbed.origins)
    keep[static_cast<std::size_t>(point)] = 1;
  keepVertices(model, keep);
  addNoise(model, disturbance.noise, disturbance.seed + 1);
  addOutliers(model, disturbance.outliers, disturbance.seed + 2);

  disturbed.surface = std::move(model.surface);
  disturbed.origins.resize(disturbed.surface.size(), no_index);
  return disturbed;
}

std::vector<Index>
undisturbMap(const std::vector<Index>& partners, const std::vector<Index>& origins, std::size_t points)
{
  std::vector<Index> before(points, no_index);
  for (std::size_t i = 0; i < partners.size(); ++i)
    if (origins[i] != no_index && partners[i] != no_index)
      before[static_cast<std::size_t>(origins[i])] = origins[static_cast<std::size_t>(partners[i])];
  return before;
}

} // namespace symmetry
} // namespace pcl
