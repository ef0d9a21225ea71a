/** \file
 * \brief A body with its coarse stand-ins, and its true map among the hubs.
 */
#pragma once

#include "support/known_body.h"
#include "symmetry/functional_map.h"
#include "symmetry/hub_surface.h"
#include "symmetry/laplacian_basis.h"

namespace pcl {
namespace symmetry {
namespace test {

struct CoarseBody {
  Model model;
  PreparedSurface surface;
  CoarseSurface coarse;
  LaplacianBasis basis;
  HubSurface hubs;

  /** \brief The hub nearest to the true partner of every hub. */
  SampleMap
  trueMap() const
  {
    SampleMap map;
    for (std::size_t i = 0; i < hubs.size(); ++i) {
      const Index partner = model.partners[coarse.cells.vertices[i]];
      map.push_back(hubs.nearest_hub[coarse.cells.owner[partner]]);
    }
    return map;
  }
};

inline PreparedSurface
preparedMesh(const Surface& mesh)
{
  return prepareSurface(mesh, SymmetryParameters{}, NeighbourSearch{});
}

/** \brief 700 samples, 250 of them hubs, 40 eigenfunctions. */
inline CoarseBody
coarseBody(Body kind, double bend, std::uint64_t seed = 1)
{
  CoarseBody result;
  result.model = body(kind, bend, seed);
  result.surface = preparedMesh(result.model.surface);
  result.coarse = coarsenSurface(result.surface, 700);
  result.basis = laplacianBasis(result.coarse, 40);
  result.hubs = makeHubSurface(result.coarse, 250, Metric::Geodesic, 1);
  return result;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
