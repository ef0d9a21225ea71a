/** \file
 * \brief Bodies described for a comparison of the names of their sides, left being the source side.
 */
#pragma once

#include "support/sample_partners.h"
#include "symmetry/names/comparable_surface.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief The sample at the true partner of every sample. */
inline SampleMap
trueSampleMap(const CoarseBody& body)
{
  SampleMap map;
  for (const Index partner : truePartners(body)) {
    map.push_back(body.coarse.cells.owner[partner]);
  }
  return map;
}

/** \brief 1 where x is positive in the rest pose, -1 where it is negative; models of a kind of body have the same
 * vertices in every pose. */
inline std::vector<float>
leftAsSource(const CoarseBody& body, Body kind)
{
  const Model at_rest = test::body(kind, 0.0);
  std::vector<float> sides;
  for (const Index v : body.coarse.cells.vertices) {
    const float x = at_rest.surface.points[v][0];
    sides.push_back(x > 0.01F ? 1.0F : x < -0.01F ? -1.0F : 0.0F);
  }
  return sides;
}

inline ComparableSurface
namedBody(const CoarseBody& body, Body kind)
{
  return comparableSurface(body.sampled(), trueSampleMap(body), leftAsSource(body, kind));
}

inline ComparableSurface
namedBody(Body kind, double bend, std::uint64_t seed)
{
  return namedBody(coarseBody(kind, bend, seed), kind);
}

} // namespace test
} // namespace symmetry
} // namespace pcl
