#include "symmetry/sides/side_growth.h"

#include "base/heartbeat.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace pcl {
namespace symmetry {
namespace {

constexpr GrowthOfSidesSettings settings{};

/** A point next to one that has a side. */
struct Reached {
  float way;       ///< from its partner, less for the side that the side function denies
  float agreement; ///< of the side with the side function: decides between a point and its partner
  Index point;
  float side; ///< 1 or -1

  bool
  operator<(const Reached& other) const
  {
    return std::tie(way, agreement, other.point) < std::tie(other.way, other.agreement, point);
  }
};

/** Floods the surface. */
class SideGrowth {
public:
  SideGrowth(const SurfaceGraph& graph, const std::vector<float>& ways, const std::vector<float>& side_function)
      : graph_(graph), ways_(ways), side_function_(side_function), sides_(graph.size(), 0.0F)
  {
    for (std::size_t v = 0; v < sides_.size(); ++v) {
      if (std::abs(side_function[v]) >= settings.clear) {
        sides_[v] = side_function[v] > 0.0F ? 1.0F : -1.0F;
      }
    }
    for (std::size_t v = 0; v < sides_.size(); ++v) {
      if (sides_[v] != 0.0F) {
        reachAround(static_cast<Index>(v));
      }
    }
  }

  void
  grow(const std::vector<Index>& partners)
  {
    while (!front_.empty()) {
      heartbeat();
      const Reached next = front_.top();
      front_.pop();
      if (sides_[next.point] == 0.0F) {
        settle(next.point, next.side);
        const Index partner = partners[next.point];
        if (sides_[partner] == 0.0F) {
          settle(partner, -next.side);
        }
      }
    }
  }

  const std::vector<float>&
  sides() const
  {
    return sides_;
  }

private:
  void
  settle(Index v, float side)
  {
    sides_[v] = side;
    reachAround(v);
  }

  void
  reachAround(Index v)
  {
    for (const Index w : graph_.neighboursOf(v)) {
      if (sides_[w] == 0.0F) {
        const float agreement = sides_[v] * side_function_[w];
        front_.push({(agreement > 0.0F ? 1.0F : settings.denied) * ways_[w], agreement, w, sides_[v]});
      }
    }
  }

  const SurfaceGraph& graph_;
  const std::vector<float>& ways_;
  const std::vector<float>& side_function_;
  std::vector<float> sides_;
  std::priority_queue<Reached> front_;
};

} // namespace

std::vector<float>
growSides(const SurfaceGraph& graph,
          const std::vector<Index>& partners,
          const std::vector<float>& ways,
          const std::vector<float>& side_function)
{
  SideGrowth growth(graph, ways, side_function);
  growth.grow(partners);
  std::vector<float> signed_ways = growth.sides();
  for (std::size_t v = 0; v < signed_ways.size(); ++v) {
    signed_ways[v] *= std::max(ways[v], std::numeric_limits<float>::min()); // what does not move has a side as well
  }
  return signed_ways;
}

} // namespace symmetry
} // namespace pcl
