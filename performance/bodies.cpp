#include "bodies.h"

#include "model/articulated_body.h"

#include <map>

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

const CoarseHuman&
coarseHuman(std::int64_t vertices)
{
  static std::map<std::int64_t, CoarseHuman> humans;
  const auto [entry, is_new] = humans.try_emplace(vertices);
  if (is_new) {
    CoarseHuman& result = entry->second;
    result.coarse = coarsenSurface(human(vertices).surface, 1500);
    result.basis = laplacianBasis(result.coarse, 60);
    result.landmarks = makeLandmarkSurface(result.coarse, 600, Metric::Geodesic, 1);
  }
  return entry->second;
}

} // namespace performance
} // namespace symmetry
} // namespace pcl
