/** \file
 * \brief A body with its coarse stand-ins, and its true map among the landmarks.
 */
#pragma once

#include "support/known_body.h"
#include "support/prepared.h"
#include "symmetry/samples/sample_map.h"
#include "symmetry/samples/sampled_surface.h"

namespace pcl {
namespace symmetry {
namespace test {

struct CoarseBody {
  Model model;
  PreparedSurface surface;
  CoarseSurface coarse;
  LaplacianBasis basis;
  LandmarkSurface landmarks;

  /** \brief All that the steps work on; a copy, but for the surface. */
  SampledSurface
  sampled() const
  {
    const SamplingSettings settings;
    const CellMembers members = membersOfCells(coarse);
    return {surface,
            coarse,
            basis,
            landmarks,
            interpolateFromSamples(surface, coarse),
            members,
            thinnedMembers(members, settings.probes),
            describeShape(coarse, basis, settings.dimensions, settings.descriptor)};
  }

  /** \brief The landmark nearest to the true partner of every landmark. */
  SampleMap
  trueMap() const
  {
    SampleMap map;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      const Index partner = model.partners[coarse.cells.vertices[i]];
      map.push_back(landmarks.nearest_landmark[coarse.cells.owner[partner]]);
    }
    return map;
  }
};

/** \brief 700 samples, 250 of them landmarks, 40 eigenfunctions. */
inline CoarseBody
coarseBody(Body kind, double bend, std::uint64_t seed = 1)
{
  CoarseBody result;
  result.model = body(kind, bend, seed);
  result.surface = preparedMesh(result.model.surface);
  result.coarse = coarsenSurface(result.surface, 700);
  result.basis = laplacianBasis(result.coarse, 40);
  result.landmarks = makeLandmarkSurface(result.coarse, 250, Metric::Geodesic);
  return result;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
