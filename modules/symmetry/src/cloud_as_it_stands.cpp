#include "symmetry/cloud_as_it_stands.h"

#include "symmetry/robust_method.h"
#include "symmetry/surface/surface_preparation.h"

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

CloudAsItStands::CloudAsItStands(const Surface& cloud,
                                 const SymmetryParameters& parameters,
                                 const NeighbourSearch& search)
    : parameters_(parameters), surface_(prepareAsItStands(cloud, parameters, search))
{
}

bool
CloudAsItStands::isInParts() const
{
  return !surface_.part_of.empty();
}

std::optional<Interpretation>
CloudAsItStands::mirrored(float confidence, StepTimer& timer)
{
  const RobustSettings settings;
  if (surface_.size() < minimum_samples) {
    return std::nullopt;
  }
  const std::vector<MirrorFit> planes = mirrorPlanesOf(surface_, settings.sampling.samples, settings.mirror);
  if (planes.empty() || planes.front().is_of_part || planes.front().share <= confidence) {
    return std::nullopt;
  }
  const SampledSurface sampled = sampleSurface(surface_, settings.sampling, parameters_.metric, timer);
  if (sampled.coarse.size() < minimum_samples) {
    return std::nullopt;
  }
  timer.start("dense", 0.8);
  MapEstimate estimate = estimateByMirror(sampled, planes, parameters_, settings.mirror);
  return Interpretation{std::move(surface_), std::move(estimate)};
}

} // namespace symmetry
} // namespace pcl
