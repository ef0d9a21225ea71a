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
checkRange(const char* name, double value, double minimum, double maximum)
{
  if (value >= minimum && value <= maximum)
    return;
  std::ostringstream message;
  message << name << ' ' << value << " is not in [" << minimum << ", " << maximum << ']';
  throw pcl::BadArgumentException(message.str());
}

/** Marks the points that stay when a share of them is dropped at random. */
std::vector<char>
markUndropped(std::size_t points, double drop, std::uint64_t seed)
{
  std::vector<Index> order(points);
  std::iota(order.begin(), order.end(), Index{0});
  RandomNumbers(seed).shuffle(order);
  std::vector<char> keep(points, 0);
  order.resize(points - static_cast<std::size_t>(drop * static_cast<double>(points)));
  for (const Index point : order)
    keep[static_cast<std::size_t>(point)] = 1;
  return keep;
}

void
unmark(std::vector<char>& keep, const std::vector<char>& others)
{
  std::transform(keep.begin(), keep.end(), others.begin(), keep.begin(),
                 [](char a, char b) { return static_cast<char>(a != 0 && b != 0); });
}

/** Marks the points that no disturbance takes away. */
std::vector<char>
markRemaining(const Surface& surface, const Disturbance& disturbance)
{
  std::vector<char> keep = markUndropped(surface.size(), disturbance.drop, disturbance.seed);
  unmark(keep, markOutsideHoles(surface, disturbance.holes, disturbance.hole_share, disturbance.seed + 3));
  unmark(keep, markThinnedOut(surface.points, disturbance.thin, disturbance.seed + 4));
  return keep;
}

} // namespace

void
checkDisturbance(const Disturbance& disturbance)
{
  checkRange("noise", disturbance.noise, 0.0, 1.0);
  checkRange("drop", disturbance.drop, 0.0, 0.99);
  checkRange("outliers", disturbance.outliers, 0.0, 1.0);
  checkRange("hole share", disturbance.hole_share, 0.0, 0.9);
  checkRange("thin", disturbance.thin, 1.0, 1000.0);
  checkRange("quantise", disturbance.quantise, 0.0, 1.0);
  checkRange("repeat", disturbance.repeat, 0.0, 1.0);
  checkRange("bend", disturbance.bend, 0.0, 3.0);
}

DisturbedSurface
disturb(const Surface& surface, const Disturbance& disturbance)
{
  checkDisturbance(disturbance);
  const std::vector<char> keep = markRemaining(surface, disturbance);
  DisturbedSurface disturbed;
  for (std::size_t point = 0; point < keep.size(); ++point)
    if (keep[point] != 0)
      disturbed.origins.push_back(static_cast<Index>(point));

  Model model{surface, std::vector<Index>(surface.size(), no_index)};
  keepVertices(model, keep);
  bend(model, disturbance.bend, disturbance.seed + 6);
  addNoise(model, disturbance.noise, disturbance.seed + 1);
  quantise(model, disturbance.quantise);
  for (const Index point : repeatPoints(model, disturbance.repeat, disturbance.seed + 5))
    disturbed.origins.push_back(Index{disturbed.origins[static_cast<std::size_t>(point)]});
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
