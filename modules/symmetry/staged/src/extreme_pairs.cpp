#include "symmetry/staged/extreme_pairs.h"

#include "symmetry/staged/staged_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr ExtremitySettings settings{};

/** Numbers of four extreme points: the first two are partners, and so are the last two. */
using Grouping = std::array<std::size_t, 4>;

/** The three ways to make two pairs of four points. */
std::array<Grouping, 3>
groupingsOf(std::size_t a, std::size_t b, std::size_t c, std::size_t d)
{
  return {{{a, b, c, d}, {a, c, b, d}, {a, d, b, c}}};
}

/** Extreme points as the surface's distances see them. */
class ExtremeDistances {
public:
  ExtremeDistances(const std::vector<Index>& points, const SurfaceMetric& metric, const std::vector<Index>& landmarks)
      : points_(points), fields_(metric.fields(points))
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<float> sorted;
      for (const Index landmark : landmarks) {
        sorted.push_back(fields_.row(i)[landmark]);
      }
      std::sort(sorted.begin(), sorted.end());
      distributions_.push_back(std::move(sorted));
    }
  }

  std::size_t
  size() const
  {
    return points_.size();
  }

  float
  between(std::size_t a, std::size_t b) const
  {
    return fields_.row(a)[points_[b]];
  }

  float
  largest() const
  {
    float largest = 0.0F;
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        largest = std::max(largest, between(i, j));
      }
    }
    return largest;
  }

  /** How differently the distances from two points to the landmarks are distributed: the mean step between the two
   * distribution functions. */
  float
  unlikeness(std::size_t a, std::size_t b) const
  {
    float sum = 0.0F;
    for (std::size_t i = 0; i < distributions_[a].size(); ++i) {
      sum += std::abs(distributions_[a][i] - distributions_[b][i]);
    }
    return sum / static_cast<float>(std::max<std::size_t>(distributions_[a].size(), 1));
  }

  float
  unlikeness(const Grouping& g) const
  {
    return unlikeness(g[0], g[1]) + unlikeness(g[2], g[3]);
  }

  /** The pairs with their sides: those of one side are nearer to each other. */
  ExtremePairs
  withSides(const Grouping& g) const
  {
    ExtremePairs pairs{points_[g[0]], points_[g[1]], points_[g[2]], points_[g[3]]};
    if (between(g[0], g[3]) + between(g[1], g[2]) < between(g[0], g[2]) + between(g[1], g[3])) {
      std::swap(pairs.f1, pairs.f2);
    }
    return pairs;
  }

private:
  const std::vector<Index>& points_;
  DistanceFields fields_;
  std::vector<std::vector<float>> distributions_; ///< per point: its distances to the landmarks, rising
};

/** Of the three ways to make two pairs of four points the one whose partners see the surface most alike. */
Grouping
groupByDistribution(const ExtremeDistances& extremes)
{
  const std::array<Grouping, 3> groupings = groupingsOf(0, 1, 2, 3);
  return *std::min_element(groupings.begin(), groupings.end(), [&](const Grouping& a, const Grouping& b) {
    return extremes.unlikeness(a) < extremes.unlikeness(b);
  });
}

/** By how much the distances of a point to the four change, on average, when they are swapped and it goes to another. */
float
changeOf(std::size_t point, std::size_t image, const Grouping& g, const ExtremeDistances& extremes)
{
  float sum = 0.0F;
  for (std::size_t i = 0; i < g.size(); ++i) {
    sum += std::abs(extremes.between(point, g[i]) - extremes.between(image, g[i ^ 1U]));
  }
  return 0.25F * sum;
}

/** The same for the foremost points that are in no pair, each going where it fits best. */
float
changeOfOthers(const Grouping& g, const ExtremeDistances& extremes)
{
  const auto is_other = [&g](std::size_t point) {
    return std::find(g.begin(), g.end(), point) == g.end();
  };
  float sum = 0.0F;
  std::size_t others = 0;
  for (std::size_t point = 0; point < std::min(extremes.size(), settings.foremost_points); ++point) {
    if (!is_other(point)) {
      continue;
    }
    float least = std::numeric_limits<float>::max();
    for (std::size_t image = 0; image < extremes.size(); ++image) {
      if (is_other(image)) {
        least = std::min(least, changeOf(point, image, g, extremes));
      }
    }
    sum += least;
    ++others;
  }
  return others == 0 ? 0.0F : sum / static_cast<float>(others);
}

/** See chooseExtremePairs (). */
float
costOf(const Grouping& g, const ExtremeDistances& extremes)
{
  float spread = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      spread = std::min(spread, extremes.between(g[i], g[j]));
    }
  }
  if (spread <= 0.0F) {
    return std::numeric_limits<float>::max();
  }
  const float between_pairs = std::abs(extremes.between(g[0], g[2]) - extremes.between(g[1], g[3])) +
                              std::abs(extremes.between(g[0], g[3]) - extremes.between(g[1], g[2]));
  const float change = 0.5F * extremes.unlikeness(g) + 0.5F * between_pairs + changeOfOthers(g, extremes);
  return (change + settings.usual_change * extremes.largest()) / spread;
}

/** The same pairs, the lesser point of each first, and the pair with the least point first. */
template <typename Precedes>
Grouping
inOrder(Grouping g, Precedes precedes)
{
  for (const std::size_t pair : {0U, 2U}) {
    if (precedes(g[pair + 1], g[pair])) {
      std::swap(g[pair], g[pair + 1]);
    }
  }
  return precedes(g[2], g[0]) ? Grouping{g[2], g[3], g[0], g[1]} : g;
}

} // namespace

const std::vector<float>&
pairingFeature(const ExtremityFunctions& functions, PairingFeature feature)
{
  const bool large = functions.average.size() >= settings.points_of_large_surface;
  return feature == PairingFeature::MinimalGeodesicDistance || (feature == PairingFeature::BySurfaceSize && large)
             ? functions.minimal
             : functions.average;
}

ExtremePairs
pairExtremePoints(const std::array<Index, 4>& points,
                  const std::vector<float>& feature,
                  const SurfaceMetric& metric,
                  const std::vector<Index>& landmarks)
{
  std::vector<Index> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [&feature](Index a, Index b) { return feature[a] != feature[b] ? feature[a] < feature[b] : a < b; });
  const ExtremeDistances extremes(sorted, metric, landmarks);

  const float smallest_step = settings.clear_step * feature[sorted.back()];
  const auto step = [&](std::size_t i) {
    return feature[sorted[i + 1]] - feature[sorted[i]];
  };
  const bool clear = step(1) >= std::max({step(0), step(2), smallest_step});
  return extremes.withSides(clear ? Grouping{0, 1, 2, 3} : groupByDistribution(extremes));
}

ExtremePairs
chooseExtremePairs(const std::vector<Index>& points,
                   const std::vector<float>& feature,
                   const SurfaceMetric& metric,
                   const std::vector<Index>& landmarks)
{
  const ExtremeDistances extremes(points, metric, landmarks);
  const auto precedes = [&](std::size_t i, std::size_t j) {
    return feature[points[i]] != feature[points[j]] ? feature[points[i]] < feature[points[j]] : points[i] < points[j];
  };
  Grouping best = {0, 1, 2, 3};
  float least = costOf(best, extremes);
  for (std::size_t d = 3; d < points.size(); ++d) {
    for (std::size_t c = 2; c < d; ++c) {
      for (std::size_t b = 1; b < c; ++b) {
        for (std::size_t a = 0; a < b; ++a) {
          for (const Grouping& grouping : groupingsOf(a, b, c, d)) {
            const float cost = costOf(grouping, extremes);
            if (cost < least) {
              least = cost;
              best = grouping;
            }
          }
        }
      }
    }
  }
  ExtremePairs pairs = extremes.withSides(inOrder(best, precedes));
  pairs.cost = least;
  return pairs;
}

} // namespace symmetry
} // namespace pcl
