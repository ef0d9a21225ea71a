/** \file
 * \brief Partners of the samples of a body, and how far off they are.
 */
#pragma once

#include "base/vector_math.h"
#include "support/human.h"
#include "symmetry/samples/surface_patch.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief The true partner of every sample. */
inline std::vector<Index>
truePartners(const CoarseBody& body)
{
  std::vector<Index> partners;
  for (const Index v : body.coarse.cells.vertices) {
    partners.push_back(body.model.partners[v]);
  }
  return partners;
}

/** \brief Mean distance between partners and true partners, in spacings of the samples. */
inline float
errorOf(const CoarseBody& body, const std::vector<Index>& partners)
{
  const std::vector<Index> truth = truePartners(body);
  float sum = 0.0F;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    sum += distance(body.surface.points[partners[i]], body.surface.points[truth[i]]);
  }
  return sum / (static_cast<float>(partners.size()) * sampleSpacing(body.coarse));
}

} // namespace test
} // namespace symmetry
} // namespace pcl
