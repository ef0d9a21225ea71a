#include "symmetry/samples/sampled_surface.h"

namespace pcl {
namespace symmetry {

SampledSurface
sampleSurface(const PreparedSurface& surface, const SamplingSettings& settings, Metric metric, StepTimer& timer)
{
  timer.start("sampling", 0.1);
  SampledSurface sampled{surface, coarsenSurface(surface, settings.samples), {}, {}, {}, {}, {}, {}};
  if (sampled.coarse.size() < minimum_samples) {
    return sampled;
  }
  timer.start("embedding", 0.2);
  sampled.basis = laplacianBasis(sampled.coarse, settings.eigenfunctions);
  timer.start("geodesics", 0.3);
  sampled.landmarks = makeLandmarkSurface(sampled.coarse, settings.landmarks, metric);
  timer.start("features", 0.35);
  sampled.interpolation = interpolateFromSamples(surface, sampled.coarse);
  sampled.members = membersOfCells(sampled.coarse);
  sampled.probes = thinnedMembers(sampled.members, settings.probes);
  if (sampled.isSearchable()) {
    sampled.descriptor = describeShape(sampled.coarse, sampled.basis, settings.dimensions, settings.descriptor);
  }
  return sampled;
}

} // namespace symmetry
} // namespace pcl
