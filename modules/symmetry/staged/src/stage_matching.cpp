#include "symmetry/staged/stage_matching.h"

#include "symmetry/staged/dense_matcher.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace symmetry {
namespace {

struct RegionPair {
  Region source;
  Region target;
};

constexpr std::array<RegionPair, 2> limb_pairs = {RegionPair{Region::Source1, Region::Target1},
                                                  RegionPair{Region::Source2, Region::Target2}};

void
append(std::vector<SymmetricMatch>& matches, const std::vector<SymmetricMatch>& more)
{
  matches.insert(matches.end(), more.begin(), more.end());
}

/** The vertices of a list that lie on a side; those exactly between lie on both. */
std::vector<Index>
onSide(const std::vector<Index>& vertices, const std::vector<float>& sides, Side side)
{
  std::vector<Index> chosen;
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(chosen),
               [&](Index v) { return side == Side::Source ? sides[v] >= 0.0F : sides[v] <= 0.0F; });
  return chosen;
}

} // namespace

std::vector<SymmetricMatch>
matchVertices(const BaseVertices& base, const Matchable& vertices, Side side, FeatureSet set)
{
  const Side other = side == Side::Source ? Side::Target : Side::Source;
  const DenseMatcher matcher(base.features(vertices.candidates, other, set), base.floors(side, set));
  const std::vector<FeatureMatch> found = matcher.match(base.features(vertices.queries, side, set));
  std::vector<SymmetricMatch> matches;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].row >= 0) {
      const Index query = vertices.queries[i];
      const Index partner = vertices.candidates[static_cast<std::size_t>(found[i].row)];
      matches.push_back({side == Side::Source ? query : partner, side == Side::Source ? partner : query, no_index,
                         found[i].dissimilarity});
    }
  }
  return matches;
}

std::vector<SymmetricMatch>
cheapest(std::vector<SymmetricMatch> matches, std::size_t count)
{
  std::sort(matches.begin(), matches.end(), [](const SymmetricMatch& a, const SymmetricMatch& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.source != b.source ? a.source < b.source : a.target < b.target;
  });
  matches.resize(std::min(matches.size(), count));
  return matches;
}

std::vector<Index>
within(const std::vector<Index>& vertices, const std::vector<Region>& regions, Region region)
{
  std::vector<Index> chosen;
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(chosen),
               [&](Index v) { return regions[v] == region; });
  return chosen;
}

std::vector<Index>
verticesOf(const std::vector<Region>& regions, Region region)
{
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < regions.size(); ++v) {
    if (regions[v] == region) {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  return vertices;
}

std::vector<SymmetricMatch>
matchExtremities(const BaseVertices& base,
                 const std::vector<Region>& regions,
                 const std::vector<Index>& extremities,
                 std::size_t kept)
{
  std::vector<SymmetricMatch> matches;
  for (const RegionPair& limbs : limb_pairs) {
    const Matchable vertices{within(extremities, regions, limbs.source), within(extremities, regions, limbs.target)};
    append(matches, cheapest(matchVertices(base, vertices, Side::Source, FeatureSet::OwnEndpointsAndMidpoints), kept));
  }
  return matches;
}

std::vector<SymmetricMatch>
matchSamples(const BaseVertices& base,
             const std::vector<Region>& regions,
             const std::vector<float>& sides,
             const std::vector<Index>& samples,
             FeatureSet set,
             std::size_t kept)
{
  std::vector<SymmetricMatch> matches;
  for (const RegionPair& limbs : limb_pairs) {
    const Matchable vertices{within(samples, regions, limbs.source), verticesOf(regions, limbs.target)};
    append(matches, cheapest(matchVertices(base, vertices, Side::Source, set), kept));
  }
  const std::vector<Index> centre_samples = within(samples, regions, Region::Centre);
  const std::vector<Index> centre = verticesOf(regions, Region::Centre);
  std::vector<SymmetricMatch> centre_matches;
  for (const Side side : {Side::Source, Side::Target}) {
    const Side other = side == Side::Source ? Side::Target : Side::Source;
    append(centre_matches,
           matchVertices(base, {onSide(centre_samples, sides, side), onSide(centre, sides, other)}, side, set));
  }
  append(matches, cheapest(std::move(centre_matches), kept));
  return matches;
}

} // namespace symmetry
} // namespace pcl
