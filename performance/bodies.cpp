#include "bodies.h"

#include "model/articulated_body.h"
#include "symmetry/surface/surface_preparation.h"

#include <map>
#include <memory>

namespace pcl {
namespace symmetry {
namespace performance {

const Human&
human(std::int64_t vertices)
{
  static std::map<std::int64_t, Human> humans;
  const auto [entry, is_new] = humans.try_emplace(vertices);
  if (is_new) {
    ModelParameters parameters;
    parameters.body = Body::Human;
    parameters.vertices = static_cast<std::size_t>(vertices);
    parameters.seed = 4;
    Model model = makeModel(parameters);
    Human& result = entry->second;
    result.surface = prepareSurface(model.surface, {}, {});
    result.input = std::move(model.surface);
    result.partners = std::move(model.partners);
  }
  return entry->second;
}

const SampledSurface&
sampledHuman(std::int64_t vertices)
{
  static std::map<std::int64_t, std::unique_ptr<SampledSurface>> humans;
  std::unique_ptr<SampledSurface>& result = humans[vertices];
  if (!result) {
    StepTimer timer;
    result = std::make_unique<SampledSurface>(
        sampleSurface(human(vertices).surface, SamplingSettings{}, Metric::Geodesic, timer));
  }
  return *result;
}

} // namespace performance
} // namespace symmetry
} // namespace pcl
