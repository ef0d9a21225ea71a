#include "symmetry/staged/dense_map.h"

#include "symmetry/staged/dense_matcher.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t queries_at_a_time = 16384; // bounds the memory for their feature vectors

void
matchSide(const BaseVertices& base,
          const std::vector<Index>& queries,
          const std::vector<Index>& candidates,
          Side side,
          DenseMap& map)
{
  const FeatureSet set = FeatureSet::OwnEndpointsAndMidpoints;
  const Side other = side == Side::Source ? Side::Target : Side::Source;
  const DenseMatcher matcher(base.features(candidates, other, set), base.floors(side, set));
  for (std::size_t begin = 0; begin < queries.size(); begin += queries_at_a_time) {
    const std::size_t end = std::min(queries.size(), begin + queries_at_a_time);
    const std::vector<Index> some(queries.begin() + static_cast<std::ptrdiff_t>(begin),
                                  queries.begin() + static_cast<std::ptrdiff_t>(end));
    const std::vector<FeatureMatch> matches = matcher.match(base.features(some, side, set));
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (matches[i].row >= 0) {
        map.partners[some[i]] = candidates[static_cast<std::size_t>(matches[i].row)];
        map.dissimilarities[some[i]] = matches[i].dissimilarity;
      }
    }
  }
}

} // namespace

DenseMap
denseMap(const BaseVertices& base, const std::vector<float>& sides)
{
  DenseMap map;
  map.partners.assign(sides.size(), no_index);
  map.dissimilarities.assign(sides.size(), 0.0F);
  std::vector<Index> source;
  std::vector<Index> target;
  for (std::size_t v = 0; v < sides.size(); ++v) {
    (sides[v] > 0.0F ? source : target).push_back(static_cast<Index>(v));
  }
  matchSide(base, source, target, Side::Source, map);
  matchSide(base, target, source, Side::Target, map);
  return map;
}

} // namespace symmetry
} // namespace pcl
